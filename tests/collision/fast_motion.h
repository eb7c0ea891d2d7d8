// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "collision/contact_oracle.h"
#include "collision/proxy/proxy_solver.h"
#include "instruments/ten_patches.h"
#include "instruments/tool_trajectory.h"
#include "support/servo_tick.h"

// The depth of the proxy under fast motion, tick by tick, compared with the exact depth.
namespace tactooth::test {

inline constexpr double kExactEnough = 5e-4;                           // mm
inline constexpr double kTipSpeeds[] = {10, 66, 100, 250, 500, 1000};  // mm/s

/// Errors along a path.
struct SpeedReport {
    int ticks = 0;
    int touching = 0;
    int wrong = 0;         ///< ticks whose depth is not the exact one
    int intersecting = 0;  ///< according to the oracle
    double worst = 0;      ///< mm
    int firstWrong = -1;   ///< tick
};

/// A path of the device from above to `place`: it presses, slides to and fro, presses deeper and leaves.
[[nodiscard]] std::vector<Pose> pathOver(const Vec3& place, double speed);

/// Leads a tool over the ten patches. The exact depth is that of the ten half-spaces.
[[nodiscard]] SpeedReport checkOverPatches(const TenPatches& piece, const TriangleMesh& tool, const Vec3& place,
                                           double speed);

/// Leads a tool over a tooth. A depth is exact if it equals that of the same path in much finer steps. Or else if the
/// pose is proven to be a local minimum of the distance to the device pose, with no straight path nearer: where a tool
/// can rest on either side of a ridge, the history decides, and the finer steps have another history.
[[nodiscard]] SpeedReport checkOverTooth(const TriangleMesh& tooth, const TriangleMesh& tool, double speed, int strokes,
                                         int subSteps);

/// The number of strokes that take some hundred ticks.
[[nodiscard]] inline int fewStrokes(double speed) { return speed > 200 ? 6 : speed > 50 ? 3 : 1; }

}  // namespace tactooth::test
