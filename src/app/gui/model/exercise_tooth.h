// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "assessment/exercise.h"
#include "session/model/session_tooth.h"

namespace tactooth {

/// The tooth of an exercise together with its bur. Takes up to a few seconds: run it in a Task. Fails with one sentence
/// for the user.
[[nodiscard]] Expected<SessionTooth> makeSessionTooth(const std::shared_ptr<const Exercise>& exercise,
                                                      const ShareDone& progress = {});

/// The exercise that the tooth was made for; null: free practice.
[[nodiscard]] std::shared_ptr<const Exercise> exerciseOf(const SessionTooth& tooth);
void setExercise(SessionTooth& tooth, std::shared_ptr<const Exercise> exercise);

/// FDI number of the tooth that an exercise is for; 0: unknown, as for files.
[[nodiscard]] int fdiOf(const Exercise& exercise);
/// FDI number of the tooth on the bench: by the mouth, its exercise, or its name; 0: unknown.
[[nodiscard]] int fdiOf(const SessionTooth& tooth);

}  // namespace tactooth
