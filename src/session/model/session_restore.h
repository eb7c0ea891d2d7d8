// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "session/model/session_tooth.h"
#include "session/recording/recording_folder.h"

namespace tactooth {

/// What an unfinished session holds, for the question whether to restore it.
struct LeftoverFacts {
    std::string title;  ///< of the tooth
};

/// Nothing if there is no work in it: it cannot be read, nothing was cut, or it was ended in the meantime. Such a file
/// is put away: `folder` removes a recording without work, and gives a finished one its name. Reads the whole file: run
/// it in a Task.
[[nodiscard]] std::optional<LeftoverFacts> examine(const Leftover& leftover, const RecordingFolder& folder);

/// How far a restoration has come; any thread.
struct RestoreProgress {
    std::atomic<double> part{0};     ///< 0 to 1
    std::atomic<bool> stops{false};  ///< set it to give up
};

/// The tooth as it was when the session stopped, with bur, exercise, time and events; its cuts count as unsaved. A
/// recording is simulated again to its last whole block, some ten times as fast as it was recorded; where that differs
/// from the recording it ends, and an import note says so. Run it in a Task. Fails with one sentence.
[[nodiscard]] Expected<SessionTooth> restoreSession(const Leftover& leftover, RestoreProgress& progress);

}  // namespace tactooth
