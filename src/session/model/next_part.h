// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "session/kernel/session_event.h"
#include "session/model/task.h"
#include "session/recording/recording_folder.h"
#include "session/simulation/cut_history.h"

namespace tactooth {

/// Says when the recording of a session that has stopped can go on in another file, its next part. One thread.
class NextPart {
public:
    explicit NextPart(const TaskExecutor& executor) : trial_(executor) {}

    /// Another tooth: nothing is wanted.
    void reset();
    /// The recording has stopped, though its folder takes more: another part can begin at once.
    void wantNow();
    /// The disk or the folder has failed: another part can begin when a trial shows that it takes more. The first one
    /// is after two seconds, and later each time this is called again for the same tooth.
    void wantWhenWritable();
    /// A part begins; `history`: of the tooth now.
    void begun(const CutHistory& history);

    [[nodiscard]] bool isWanted() const { return wantedSince_.has_value(); }
    /// Whether it can begin now. `bytes`: what it takes at least.
    [[nodiscard]] bool isPossible(const RecordingFolder& folder, std::uint64_t bytes);
    /// Whether it was possible for so long that it should not wait for a better moment.
    [[nodiscard]] bool isOverdue() const;

    /// Whether a replay of the newest part can do this. What was cut before it can only be taken back in the session
    /// itself. `history`: of the tooth now.
    [[nodiscard]] bool canReplay(Edit edit, const CutHistory& history) const;

private:
    using Clock = std::chrono::steady_clock;

    Task<bool> trial_;
    std::optional<Clock::time_point> wantedSince_, possibleSince_;
    Clock::time_point nextTrial_{};
    Clock::duration wait_{};
    std::size_t doneBefore_ = 0, undoneBefore_ = 0;  // steps of the tooth when the part began
};

}  // namespace tactooth
