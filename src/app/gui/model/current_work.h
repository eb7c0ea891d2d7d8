// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "assessment/exercise.h"
#include "session/model/session_model.h"

namespace tactooth {

/// What the user is doing now, with time and events: for a saved tooth. `exercise`: null for free practice;
/// `targetFile`: of the user's own target.
[[nodiscard]] SessionWork currentWork(const SessionModel& model, const std::shared_ptr<const Exercise>& exercise,
                                      const std::string& targetFile);

/// Goes on with the exercise and the target of `tooth.work`: finds them among the built-in ones, else under their path,
/// in `folder`, or among `known` files (by name). What is not there any more is an import note. Reads files: run it in
/// a Task.
void resumeWork(SessionTooth& tooth, const std::filesystem::path& folder,
                const std::vector<std::filesystem::path>& known);

/// loadSessionTooth, and goes on with the work on a saved tooth.
[[nodiscard]] Expected<SessionTooth> openSessionTooth(const ToothSource& source, const std::string& workOn,
                                                      const std::vector<std::filesystem::path>& known,
                                                      const ShareDone& progress = {});

}  // namespace tactooth
