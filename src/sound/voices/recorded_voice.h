// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "sound/voices/gain_smoother.h"
#include "sound/voices/loop_player.h"
#include "sound/voices/sound_kit.h"

namespace tactooth {

/// A recording at a given level.
class RecordedVoice {
public:
    /// Adds its sound to `out` (at most kControlFrames samples) while the bur makes `turnsPerFrame`; its root mean
    /// square moves toward `level` by `share`, as from smoothingCoefficient(). The same part each time.
    void addTo(std::span<float> out, const RecordedPart& part, double level, float share,
               std::span<const double> turnsPerFrame);

private:
    LoopPlayer player_;
    GainSmoother gain_;
};

}  // namespace tactooth
