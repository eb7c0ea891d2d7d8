// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "haptics/haptic_simulation.h"

namespace tactooth {

/// How the force is computed, as far as the user or the device may change it while the simulation runs.
struct ForceParameters {
    ForceOverrides overrides;  ///< empty: the materials' own values
    double scale = 1;
    double maxStiffness = std::numeric_limits<double>::infinity();  ///< of the device, N/mm

    friend bool operator==(const ForceParameters&, const ForceParameters&) = default;
};

/// All that one tick of the servo thread reads from outside, on a fixed grid. The simulation uses these numbers and no
/// others, so that a recording holds exactly what was simulated. The grid is finer than the encoders of any device.
struct TickInput {
    static constexpr double kPositionStep = 1.0 / (1 << 12);  ///< mm
    static constexpr double kRotationStep = 1.0 / (1 << 24);  ///< of a component of the unit quaternion
    static constexpr double kPedalStep = 1.0 / (1 << 16);
    static constexpr double kTimeStep = 1.0 / (1 << 20);  ///< s

    std::array<std::int64_t, 3> position{};  ///< of the device in the tooth frame, in steps
    std::array<std::int32_t, 4> rotation{};  ///< x, y, z, w, in steps
    std::int32_t elapsed = 0;                ///< since the last tick, in steps; not negative
    std::int32_t pedal = 0;                  ///< in steps, 0 up
    bool cutting = false;
    bool hasPose = false;  ///< false: the device has no valid pose

    /// The nearest input on the grid. A pose that is not finite, or farther away than a kilometre, is none. `elapsed`
    /// is in s; a time that is not finite, negative, or longer than 15 minutes counts as zero.
    [[nodiscard]] static TickInput of(const OperatorInput& input, double elapsed);
    /// What the simulation gets; the position is NaN without a pose.
    [[nodiscard]] OperatorInput operatorInput() const;
    /// s
    [[nodiscard]] double seconds() const { return kTimeStep * elapsed; }

    friend bool operator==(const TickInput&, const TickInput&) = default;
};

/// Puts the times between ticks on the grid. What is rounded off at one tick counts at the next, so that the sum stays
/// right.
class ElapsedTime {
public:
    /// Returns the time that the next tick shall use, s.
    [[nodiscard]] double next(double elapsed);

private:
    double rest_ = 0;  // s
};

}  // namespace tactooth
