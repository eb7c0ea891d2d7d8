// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "collision/contact_oracle.h"
#include "haptics/haptic_simulation.h"
#include "instruments/tool_trajectory.h"
#include "support/servo_tick.h"

namespace tactooth::test {

[[nodiscard]] inline HapticSimulation simulationOn(const TriangleMesh& tooth, const TriangleMesh& tool,
                                                   bool closed = true) {
    const auto shape = toolOf(tool);
    return {shape, shape->radius(), surfaceOf(tooth, closed), HapticSettings{}};
}

struct ForceStats {
    double mean = 0;  ///< N
    double peak = 0;  ///< N
};

/// The force along a slide over the cusps of `ground`, on `tooth`, which is the same surface.
[[nodiscard]] inline ForceStats forceAlong(const TriangleMesh& ground, const TriangleMesh& tooth, double speed) {
    ToolTrajectory how;
    how.speed = speed;
    how.strokes = 1;
    how.stroke = 3;
    HapticSimulation simulation = simulationOn(tooth, oracleTools()[0].mesh);
    ForceStats hapticSurface;
    const std::vector<Pose> path = toolTrajectory(ground, how);
    for (const Pose& hand : path) {
        const double force = simulation.step({hand, 0, false}, kTick).force.wrench.force.norm();
        hapticSurface.mean += force / static_cast<double>(path.size());
        hapticSurface.peak = std::max(hapticSurface.peak, force);
    }
    return hapticSurface;
}

}  // namespace tactooth::test
