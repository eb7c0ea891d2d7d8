// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <random>

#include "collision/contact_oracle.h"
#include "collision/proxy/candidate_step.h"
#include "collision/proxy/proxy_context.h"
#include "collision/proxy/proxy_solver.h"
#include "support/shapes.h"

namespace tactooth::test {

inline constexpr double kMargin = 1e-6;  // mm

[[nodiscard]] inline Pose poseAt(double x, double y, double z) { return {Vec3(x, y, z), Quat::Identity()}; }

/// A cube of 1 mm with its origin in the middle of its lower side.
[[nodiscard]] inline TriangleMesh smallBox() { return box(Vec3(-0.5, -0.5, 0), Vec3(0.5, 0.5, 1)); }
/// A block whose upper side is the plane z = 0.
[[nodiscard]] inline TriangleMesh floorBlock() { return box(Vec3(-10, -10, -1), Vec3(10, 10, 0)); }
/// One triangle.
[[nodiscard]] inline TriangleMesh oneTriangle(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    TriangleMesh mesh;
    mesh.vertices = {a, b, c};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

/// The data of a solver with a tool and a tooth, without a neighbour list.
[[nodiscard]] inline ProxyContext contextOf(const TriangleMesh& tool, const TriangleMesh& tooth, const Pose& pose,
                                            Freedom freedom = Freedom::Translation) {
    ProxyContext context(toolOf(tool), freedom);
    context.scene.surface = surfaceOf(tooth);
    context.scene.pose = pose;
    context.scene.margin = kMargin;
    return context;
}

/// Gives the solver a neighbour list of all pairs within `around` (mm) and a rotation by `turn` (chord) of its pose.
inline void listAround(ProxyContext& context, double around, double turn = 0.01) {
    NeighbourList near(*context.scene.tool);
    near.buildAll(*context.scene.surface, context.scene.pose, ContactMargin{Vec3::Zero(), around, turn});
    context.horizon.take(near);
}

/// A step that shifts the tool, without rotation.
[[nodiscard]] inline CandidateStep stepBy(const ProxyContext& context, const Vec3& shift) {
    CandidateStep step;
    step.goal = {context.scene.pose.position + shift, context.scene.pose.rotation};
    step.rotateBy(context.scene.pose.rotation, 0);
    step.shift = shift;
    step.limits = {100, 2, 100};
    return step;
}

/// A solver among the triangles of a tooth, with its proxy at a free pose.
[[nodiscard]] inline ProxySolver solverAt(const Pose& start, std::shared_ptr<const ToolShape> tool,
                                          std::shared_ptr<const Surface> tooth,
                                          Freedom freedom = Freedom::Translation) {
    ProxySolver solver(std::move(tool), freedom);
    solver.setSurface(std::move(tooth));
    solver.placeAt(start);
    return solver;
}

/// Moves toward `goal` until the proxy has settled, at most 200 times.
inline MoveResult settle(ProxySolver& solver, const Pose& goal) {
    MoveResult result;
    for (int i = 0; i < 200; ++i) {
        result = solver.moveToward(goal);
        if (result.status != MoveStatus::OutOfIterations && result.status != MoveStatus::OutOfBudget) return result;
    }
    ADD_FAILURE() << "the proxy did not settle";
    return result;
}

/// Three independent numbers with a standard normal distribution.
[[nodiscard]] inline Vec3 randomVector(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const double x = normal(random), y = normal(random), z = normal(random);
    return {x, y, z};
}

}  // namespace tactooth::test
