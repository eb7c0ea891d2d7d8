// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "session/recording/session_recording.h"
#include "session/track/session_track.h"
#include "support/test_data.h"

namespace tactooth::test {

/// A recorded session of a synthetic hand: a bur cuts two holes into a block with its top at z = 0: one at x = -1 from
/// 1 to 2 s, upright, and one at x = 1 from 4 to 5 s, tilted toward it by kTilt.
class TwoHoles {
public:
    static constexpr double kTilt = 0.2;                          // rad
    static constexpr double kFirstHole = 1.0, kSecondHole = 4.0;  // s

    /// Null, with failed tests, where it could not be recorded.
    static const TwoHoles* recorded();

    [[nodiscard]] const SessionRecording& recording() const { return *recording_; }
    [[nodiscard]] const std::shared_ptr<const SessionTrack>& track() const { return track_; }

private:
    TwoHoles() = default;
    void record();

    TemporaryFolder folder_;  // shards of a program run at the same time
    std::shared_ptr<SessionRecording> recording_;
    std::shared_ptr<const SessionTrack> track_;
};

}  // namespace tactooth::test
