// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Shapes whose depth is known in closed form, for the stateless query and for the proxy: a ball of triangles on a
// plane, on an edge and on a corner of a block, in a V-groove and in the corner of three walls. The tolerance is a
// nanometre plus a billionth of the depth.
#include <gtest/gtest.h>

#include <random>

#include "collision/contact_oracle.h"
#include "collision/proxy/contact_query.h"
#include "collision/proxy/proxy_solver.h"
#include "collision/proxy/qp3.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kNanometre = 1e-6;  // mm
constexpr int kMotions = 400;

double allowed(double depth) { return kNanometre + 1e-9 * depth; }

std::vector<Vec3> cornersAt(const TriangleMesh& mesh, const Pose& pose) {
    std::vector<Vec3> corners;
    for (const Vec3f& v : mesh.vertices) corners.push_back(pose * v.cast<double>());
    return corners;
}

std::vector<Vec3> edgesOf(const TriangleMesh& mesh, const Quat& rotation) {
    std::vector<Vec3> edges;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int i = 0; i < 3; ++i) {
            if (mesh.triangles[t][i] < mesh.triangles[t][(i + 1) % 3])  // once for each edge of a closed mesh
                edges.push_back(rotation * (mesh.corner(t, (i + 1) % 3) - mesh.corner(t, i)));
        }
    }
    return edges;
}

struct ExitDirection {
    double depth;
    Vec3 direction;
};

/// The shortest exit of one convex body from another: the least overlap along any direction. The candidates are the
/// normals of the faces of their Minkowski difference: faces of either body, and cross products of their edges.
ExitDirection convexPenetrationDepth(const TriangleMesh& fixed, const TriangleMesh& moving, const Pose& pose) {
    const std::vector<Vec3> a = cornersAt(fixed, {});
    const std::vector<Vec3> b = cornersAt(moving, pose);
    ExitDirection best{std::numeric_limits<double>::infinity(), Vec3::Zero()};
    const auto consider = [&](const Vec3& axis) {
        const double length = axis.norm();
        if (length < 1e-9) return;
        for (const Vec3& n : {Vec3(axis / length), Vec3(axis / -length)}) {
            const double overlap = highestAlong(a, n) - lowestAlong(b, n);
            if (overlap < best.depth) best = {overlap, n};
        }
    };
    for (std::size_t t = 0; t < fixed.triangles.size(); ++t) consider(fixed.areaVector(t));
    for (std::size_t t = 0; t < moving.triangles.size(); ++t) consider(pose.rotation * moving.areaVector(t));
    for (const Vec3& edge : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {  // those of a block
        for (const Vec3& other : edgesOf(moving, pose.rotation)) consider(edge.cross(other));
    }
    return best;
}

TriangleMesh ball() { return test::sphere(Vec3::Zero(), 0.7, 16, 8); }

Quat randomRotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const double w = normal(random);
    const double x = normal(random);
    const double y = normal(random);
    return Quat(w, x, y, normal(random)).normalized();
}

/// The proxy's depth once it has settled, moving straight from outside at 10 cm/s. (A jump of millimetres may end in
/// another minimum: one of these poses is 0.5387 mm deep along two directions 10 degrees apart, to 0.2 um.)
double settledDepth(ProxySolver& solver, const Pose& device, const Vec3& outward) {
    constexpr int kTicks = 20;
    for (int tick = 0; tick <= kTicks; ++tick) {
        const Pose before{device.position + 0.1 * (kTicks - tick) * outward, device.rotation};
        if (tick == 0) solver.placeAt(before);
        solver.moveToward(before);
    }
    for (int tick = 0; tick < 4; ++tick) solver.moveToward(device);
    return (solver.pose().position - device.position).norm();
}

/// Presses the ball against the block around `place`, a point of its surface with the outward direction `outward`.
void pressOnBlock(const Vec3& place, const Vec3& outward, unsigned seed) {
    const TriangleMesh block = test::box(Vec3(-9, -9, -9), Vec3(0, 0, 0));
    const TriangleMesh tool = ball();
    ContactQuery query(test::toolOf(tool), test::surfaceOf(block));
    ProxySolver solver(test::toolOf(tool));
    solver.setSurface(test::surfaceOf(block));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> height(0.25, 0.69);
    std::uniform_real_distribution<double> aside(-0.2, 0.2);
    for (int i = 0; i < kMotions; ++i) {
        const double x = aside(random);
        const double y = aside(random);
        const Vec3 beside(x, y, aside(random));
        const Pose device{place + height(random) * outward + 0.5 * beside, randomRotation(random)};
        const ExitDirection exact = convexPenetrationDepth(block, tool, device);
        const Contact contact = query.at(device);
        if (exact.depth <= 0) {
            EXPECT_FALSE(contact.touching);
            continue;
        }
        ASSERT_TRUE(contact.touching);
        EXPECT_NEAR(contact.depth, exact.depth, allowed(exact.depth))
            << i << " " << contact.normal.dot(exact.direction);
        EXPECT_NEAR(settledDepth(solver, device, exact.direction), exact.depth, allowed(exact.depth)) << i;
    }
}

/// The exact depth of a tool in a tooth whose free space is above all of these planes, mm.
double exitFromPlanes(const std::vector<HalfSpace>& walls, const TriangleMesh& tool, const Pose& device) {
    std::vector<HalfSpace> forTheCentre = walls;
    for (HalfSpace& wall : forTheCentre) wall.offset -= lowestAlong(cornersAt(tool, device), wall.normal);
    // The nearest point of up to three half-spaces lies on some of their planes: all combinations are tried.
    double best = std::numeric_limits<double>::infinity();
    for (unsigned chosen = 0; chosen < 1U << walls.size(); ++chosen) {
        std::vector<HalfSpace> active;
        for (std::size_t i = 0; i < walls.size(); ++i) {
            if ((chosen >> i & 1U) != 0) active.push_back(forTheCentre[i]);
        }
        Eigen::MatrixXd normals(active.size(), 3);
        Eigen::VectorXd offsets(active.size());
        for (Eigen::Index i = 0; i < normals.rows(); ++i) {
            normals.row(i) = active[static_cast<std::size_t>(i)].normal.transpose();
            offsets(i) = active[static_cast<std::size_t>(i)].offset;
        }
        Vec3 step = Vec3::Zero();
        if (!active.empty())
            step = normals.transpose() * (normals * normals.transpose()).colPivHouseholderQr().solve(offsets);
        const bool free = std::ranges::all_of(
            forTheCentre, [&](const HalfSpace& wall) { return wall.normal.dot(step) >= wall.offset - 1e-12; });
        if (free) best = std::min(best, step.norm());
    }
    return best;
}

void pressIntoWalls(const TriangleMesh& mesh, const std::vector<HalfSpace>& walls, const Vec3& middle,
                    const Vec3& outward, unsigned seed) {
    const TriangleMesh tool = ball();
    ContactQuery query(test::toolOf(tool), test::surfaceOf(mesh, false));
    ProxySolver solver(test::toolOf(tool));
    solver.setSurface(test::surfaceOf(mesh, false));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> aside(-0.15, 0.15);
    int touching = 0;
    for (int i = 0; i < kMotions; ++i) {
        const double x = aside(random);
        const double y = aside(random);
        const Pose device{middle + Vec3(x, y, aside(random)), randomRotation(random)};
        const double exact = exitFromPlanes(walls, tool, device);
        const Contact contact = query.at(device);
        ASSERT_EQ(contact.touching, exact > 0) << i;
        if (!contact.touching) continue;
        ++touching;
        EXPECT_NEAR(contact.depth, exact, allowed(exact)) << i;
        EXPECT_NEAR(settledDepth(solver, device, outward), exact, allowed(exact)) << i;
    }
    EXPECT_GT(touching, kMotions / 2);
}

}  // namespace

TEST(ClosedForm, ABallOnAPlane) { pressOnBlock(Vec3(-4, -4, 0), Vec3::UnitZ(), 1); }

TEST(ClosedForm, ABallOnAnEdge) { pressOnBlock(Vec3(0, -4, 0), Vec3(1, 0, 1).normalized(), 2); }

TEST(ClosedForm, ABallOnACorner) { pressOnBlock(Vec3(0, 0, 0), Vec3(1, 1, 1).normalized(), 3); }

TEST(ClosedForm, ABallInAVGroove) {
    TriangleMesh groove;  // two planes at 45 degrees that meet along y
    groove.vertices = {{0, -10, 0}, {0, 10, 0}, {5, 10, 5}, {5, -10, 5}, {-5, 10, 5}, {-5, -10, 5}};
    groove.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {0, 4, 5}};
    const double half = std::sqrt(0.5);
    pressIntoWalls(groove, {{Vec3(-half, 0, half), 0}, {Vec3(half, 0, half), 0}}, Vec3(0, 0, 0.8), Vec3::UnitZ(), 4);
}

TEST(ClosedForm, ABallInTheCornerOfThreeWalls) {
    TriangleMesh corner;  // quarter planes x = 0, y = 0, z = 0 seen from the positive octant
    corner.vertices = {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}, {8, 0, 8}, {0, 0, 8}, {0, 8, 8}};
    corner.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}, {0, 5, 4}, {0, 3, 6}, {0, 6, 5}};
    pressIntoWalls(corner, {{Vec3::UnitX(), 0}, {Vec3::UnitY(), 0}, {Vec3::UnitZ(), 0}}, Vec3(0.6, 0.6, 0.6),
                   Vec3(1, 1, 1), 5);
}

}  // namespace tactooth
