// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/wall_guide.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kRadius = 0.5;  // of the bur, mm

Pose at(const Vec3& tip) { return {tip, Quat::Identity()}; }

/// An ideal tooth: a block with its top at z = 0 and a box of 4 x 3 x 2 mm cut into it from above.
TriangleMesh idealBlock() {
    TriangleMesh mesh;
    mesh.vertices = {{-5, -5, -6},    {5, -5, -6},    {5, 5, -6},     {-5, 5, -6},   {-5, -5, 0},  {5, -5, 0},
                     {5, 5, 0},       {-5, 5, 0},     {-2, -1.5F, 0}, {2, -1.5F, 0}, {2, 1.5F, 0}, {-2, 1.5F, 0},
                     {-2, -1.5F, -2}, {2, -1.5F, -2}, {2, 1.5F, -2},  {-2, 1.5F, -2}};
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    quad(0, 3, 2, 1);
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t next = (i + 1) % 4;
        quad(i, next, 4 + next, 4 + i);            // outside
        quad(4 + i, 4 + next, 8 + next, 8 + i);    // top
        quad(8 + i, 8 + next, 12 + next, 12 + i);  // walls of the box
    }
    quad(12, 13, 14, 15);
    return mesh;
}

class WallGuideTest : public testing::Test {
protected:
    /// How far the bur is beyond each wall and the floor of the box: a cylinder with its end at `tip`. Not negative.
    [[nodiscard]] static Vec3 beyond(const Vec3& tip) {
        return Vec3(std::abs(tip.x()) + kRadius - 2, std::abs(tip.y()) + kRadius - 1.5, -2 - tip.z()).cwiseMax(0);
    }

    SurfacePart ideal_{idealBlock()};
    std::shared_ptr<const DistanceGrid> walls_ =
        std::make_shared<const DistanceGrid>(guideWalls(ideal_, Box3(Vec3(-2, -1.5, -2), Vec3(2, 1.5, 0))));
    WallGuide guide_{walls_, RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), kRadius, 3, 64)).value()};
};

TEST_F(WallGuideTest, TheHandIsFreeInTheCavityAndAboveIt) {
    for (const Vec3& tip : {Vec3(0, 0, -1), Vec3(1.3, 0.8, -1.8), Vec3(0, 0, 4), Vec3(3.2, 0, 0.3)}) {
        const FixtureForce push = guide_.push(at(tip));
        EXPECT_EQ(push.force, Vec3::Zero()) << tip.transpose();
        EXPECT_EQ(push.beyond, 0);
    }
}

TEST_F(WallGuideTest, AWallPushesSquareToItselfAsASpringDoes) {
    for (const double deep : {0.2, 0.4, 0.7}) {
        const FixtureForce side = guide_.push(at(Vec3(2 - kRadius + deep, 0, -1)));
        EXPECT_NEAR(side.beyond, deep, 0.02);
        EXPECT_NEAR(side.force.x(), -WallGuide::kStiffness * side.beyond, 1e-6);
        EXPECT_LT(side.force.tail<2>().norm(), 0.05 * side.force.norm());
        EXPECT_NEAR(side.energy, WallGuide::kStiffness * side.beyond * side.beyond / 2, 1e-9);
        const FixtureForce floor = guide_.push(at(Vec3(0.3, 0.2, -2 - deep)));
        EXPECT_NEAR(floor.force.z(), WallGuide::kStiffness * deep, 0.02);
    }
}

TEST_F(WallGuideTest, TheForceNeverExceedsWhatAHandCanOvercome) {
    const FixtureForce push = guide_.push(at(Vec3(0, 0, -3.4)));
    EXPECT_GT(push.beyond, WallGuide::kMostForce / WallGuide::kStiffness);
    EXPECT_NEAR(push.force.norm(), WallGuide::kMostForce, 1e-9);
}

/// The force is the slope of the energy: what the hand pushes in, it gets back.
TEST_F(WallGuideTest, TheForceFollowsFromAPotential) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> side(-2.6, 2.6), height(-3, -0.6);
    constexpr double kStep = 1e-5;
    int pushed = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 tip(side(random), side(random), height(random));
        const FixtureForce here = guide_.push(at(tip));
        if (here.beyond < 0.05) continue;
        Vec3 slope;
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 step = kStep * Vec3::Unit(axis);
            slope[axis] = (guide_.push(at(tip + step)).energy - guide_.push(at(tip - step)).energy) / (2 * kStep);
        }
        // At an edge the deepest point changes, and near the middle plane of a corner the distance has two slopes.
        if (slope.norm() < 0.9 * here.force.norm() || slope.norm() > 1.1 * here.force.norm()) continue;
        ++pushed;
        EXPECT_LT((here.force + slope).norm(), 0.15 * here.force.norm()) << tip.transpose();
    }
    EXPECT_GT(pushed, 800);
}

TEST_F(WallGuideTest, AgreesWithTheBoxEverywhereInIt) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> x(-2.2, 2.2), y(-1.7, 1.7), z(-2.4, -0.9);
    int pushed = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3 tip(x(random), y(random), z(random));
        constexpr double kAtEdges = 0.05;  // mm: the grid of 0.12 mm rounds the edges of the box
        // Where the bur is beyond two of them at once, its deepest point is farther from the cavity than from either.
        const Vec3 wanted = beyond(tip);
        const double found = guide_.push(at(tip)).beyond;
        EXPECT_LE(found, wanted.norm() + kAtEdges) << tip.transpose();
        EXPECT_GE(found, wanted.maxCoeff() - 0.04) << tip.transpose();
        pushed += found > 0.05;
    }
    EXPECT_GT(pushed, 1000);
}

TEST_F(WallGuideTest, APoseThatIsNoNumberIsNotPushed) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(guide_.push(at(Vec3(kNone, 0, -3))).force, Vec3::Zero());
    EXPECT_EQ(guide_.push(at(Vec3(1e300, 0, -3))).force, Vec3::Zero());
}

}  // namespace
}  // namespace tactooth
