// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "haptics/haptic_simulation.h"

namespace tactooth {

/// A simulation of the standard bur (half its diameter: 0.7 mm) on a surface of enamel, with the built-in materials.
[[nodiscard]] HapticSimulation enamelSimulation(const std::shared_ptr<const ToolShape>& bur,
                                                const std::shared_ptr<const Surface>& surface);

/// The ticks along a path of one pose a millisecond. `Tick::micros` is the least processor time of `repeat`
/// equal runs.
[[nodiscard]] std::vector<Tick> touchPath(const std::shared_ptr<const ToolShape>& bur,
                                          const std::shared_ptr<const Surface>& surface,
                                          std::span<const Pose> devicePath, int repeat);

/// Time that a tick in contact takes, us.
struct ForceTiming {
    double p50 = 0;
    double p99 = 0;
};
[[nodiscard]] ForceTiming forceMicros(std::span<const Tick> ticks);

}  // namespace tactooth
