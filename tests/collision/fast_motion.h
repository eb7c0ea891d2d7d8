// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "collision/contact_oracle.h"
#include "collision/proxy/proxy_solver.h"
#include "instruments/ten_patches.h"
#include "instruments/tool_trajectory.h"

// The depth that the proxy gives to a fast hand, tick by tick, against the exact answer.
namespace tactooth::test {

inline constexpr double kExactEnough = 5e-4;                           // mm
inline constexpr double kTipSpeeds[] = {10, 66, 100, 250, 500, 1000};  // mm/s
inline constexpr double kTick = 1e-3;                                  // s

/// What a path has shown.
struct SpeedReport {
    int ticks = 0;
    int touching = 0;
    int wrong = 0;         ///< ticks whose depth is not the exact one
    int intersecting = 0;  ///< by the judge's word
    double worst = 0;      ///< mm
    int firstWrong = -1;   ///< tick
};

/// A hand that comes from above to `place`, presses, slides to and fro across it, presses deeper and leaves.
[[nodiscard]] std::vector<Pose> pathOver(const Vec3& place, double speed);

/// Leads a tool over the ten patches; exact is what the ten half-spaces say.
[[nodiscard]] SpeedReport checkOverPatches(const TenPatches& piece, const TriangleMesh& tool, const Vec3& place,
                                           double speed);

/// Leads a tool over a tooth. A depth is exact if it is that of the same hand followed in a hundred times finer steps,
/// or else if the pose is proven to be a local minimum of the distance to the hand, with no straight way nearer: where
/// a hand can rest on either side of a ridge, history decides, and the fine steps have another one.
[[nodiscard]] SpeedReport checkOverTooth(const TriangleMesh& tooth, const TriangleMesh& tool, double speed, int strokes,
                                         int subSteps);

/// As many as take some hundred ticks.
[[nodiscard]] inline int fewStrokes(double speed) { return speed > 200 ? 6 : speed > 50 ? 3 : 1; }

}  // namespace tactooth::test
