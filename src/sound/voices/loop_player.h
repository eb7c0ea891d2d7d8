// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "sound/files/recording.h"

namespace tactooth {

/// Plays the loop of a recording at a pitch that may change from sample to sample, without images or aliasing: a
/// windowed sinc of Recording::kTaps samples interpolates in the level that fits the pitch. Root mean square 1 at the
/// original pitch.
class LoopPlayer {
public:
    /// The highest pitch is eight times that of the recording.
    static constexpr double kMaxStep = 1 << (Recording::kLevels - 1);

    /// The next sample; `pitch` times as fast as the recording (0 holds still), within 0..kMaxStep after the conversion
    /// of rates. The same recording each time.
    [[nodiscard]] float next(const Recording& recording, double pitch);

private:
    double position_ = 0.0;  // in the loop, samples of level 0
};

}  // namespace tactooth
