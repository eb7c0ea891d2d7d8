// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "haptics/haptic_simulation.h"

namespace tactooth {

/// What a track keeps of a tick: all that pictures, plots and sound need. Poses, force, depth and speed of the bur are
/// those of the tick, bit for bit; the rest is rounded to single precision.
struct TrackTick {
    double time = 0;  ///< s since the session began
    std::array<double, 3> position{};
    std::array<double, 4> rotation{0, 0, 0, 1};  ///< x, y, z, w
    std::array<double, 3> force{};
    double depth = 0;
    double speedRpm = 0;
    float speed = 0, pedal = 0, load = 0, removalPower = 0, impactSpeed = 0, slideSpeed = 0, pullOutForce = 0;
    std::uint32_t contactOnsets = 0, pullOuts = 0;
    std::uint16_t contacts = 0;
    std::uint8_t material = 0;
    bool cutting : 1 = false;
    bool placed : 1 = false;

    [[nodiscard]] static TrackTick of(double time, const Tick& tick);
    /// A tick with what was kept. Its time is that since the session began; all else is as in an empty tick.
    [[nodiscard]] Tick tick() const;
};

}  // namespace tactooth
