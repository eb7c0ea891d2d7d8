// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/tip_measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "session/block_with_cavity.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kRadius = 0.6, kLength = 4;  // mm

/// A tooth with its top at z = 5 and its side at x = 5. A neighbour begins 0.4 mm beside it.
class AimMarkTest : public testing::Test {
protected:
    void standBeside(double top) {
        TriangleMesh mesh = test::box(kTooth.min(), kTooth.max());
        const auto own = static_cast<std::uint32_t>(mesh.triangles.size());
        uncut_ = std::make_shared<const SurfacePart>(mesh);
        append(mesh, test::box(Vec3(5.4, -5, -10), Vec3(14, 5, top)));
        auto all = std::make_shared<Surface>();
        all->base = std::make_shared<const SurfacePart>(std::move(mesh), std::vector<SurfaceTag>{}, own);
        hand_.setSurroundings({all, nullptr, uncut_});
    }
    [[nodiscard]] AimMark above(double x) const { return aimMark(hand_, head_, {Vec3(x, 0, 8), Quat::Identity()}); }
    [[nodiscard]] static double shareBeside(const AimMark& mark) {
        const auto count = std::ranges::count_if(mark.ring, [](const AimPlace& place) { return place.touchesBeside; });
        return static_cast<double>(count) / HeadOutline::kPlaces;
    }

    static inline const Box3 kTooth = Box3(Vec3(-5, -5, -10), Vec3(5, 5, 5));
    std::shared_ptr<const SurfacePart> uncut_;
    MouseManipulator hand_{kTooth, 1};
    const HeadOutline head_{*RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), kRadius, kLength, 64)), kLength};
};

TEST_F(AimMarkTest, OverTheToothAloneTouchesNothingBeside) {
    standBeside(5);
    const AimMark mark = above(0);
    ASSERT_TRUE(mark.landing);
    EXPECT_NEAR(mark.landing->z(), 5, 1e-9);
    EXPECT_EQ(mark.ring.size(), HeadOutline::kPlaces);
    EXPECT_FALSE(mark.touchesBeside());
}

/// Of a circle around x = 4.95 with a radius of 0.6 mm, the neighbour at 5.4 mm cuts off acos(0.45 / 0.6) / pi.
TEST_F(AimMarkTest, MarksThePartOfTheRingThatLiesOnANeighbour) {
    standBeside(5);
    const AimMark mark = above(4.95);
    EXPECT_NEAR(shareBeside(mark), std::acos(0.45 / kRadius) / std::numbers::pi, 1.5 / HeadOutline::kPlaces);
    for (const AimPlace& place : mark.ring) {
        if (place.touchesBeside) {
            EXPECT_GE(place.at.x(), 5.4 - 1e-9);
        }
    }
}

TEST_F(AimMarkTest, TheRingLiesOnWhatRisesBesideTheTip) {
    standBeside(5.4);
    const AimMark mark = aimMark(hand_, head_, {Vec3(4.95, 0, 5.1), Quat::Identity()});
    ASSERT_TRUE(mark.landing);
    EXPECT_NEAR(mark.landing->z(), 5, 1e-9);
    int beside = 0;
    for (const AimPlace& place : mark.ring) {
        const bool isBeside = place.at.x() > 5.2;
        EXPECT_NEAR(place.at.z(), isBeside ? 5.4 : 5, 1e-6);  // a mesh has single precision
        beside += isBeside ? 1 : 0;
    }
    EXPECT_GT(beside, 0);
}

/// A cylinder that lies along x, pressed down by its side.
TEST_F(AimMarkTest, TheRingOfABurThatIsPressedSidewaysIsAsLongAsItsHead) {
    standBeside(-9);
    const Quat lying(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitY()));
    const AimMark mark = aimMark(hand_, head_, {Vec3(-3, 0, 6), lying});
    ASSERT_EQ(mark.ring.size(), std::size_t{HeadOutline::kPlaces});
    Box3 box;
    for (const AimPlace& place : mark.ring) box.extend(place.at);
    EXPECT_NEAR(box.min().z(), 5, 1e-6);
    EXPECT_NEAR(box.max().z(), 5, 1e-6);
    EXPECT_NEAR(box.min().x(), -3, 0.05);
    EXPECT_NEAR(box.max().x(), -3 + kLength, 0.05);
    EXPECT_NEAR(box.sizes().y(), 2 * kRadius, 0.05);
}

TEST_F(AimMarkTest, ANeighbourBelowTheFloorIsNotTouched) {
    standBeside(3.5);
    hand_.setPressMode(PressMode::Depth);
    hand_.depthControl().setDepth(1);
    EXPECT_FALSE(above(4.95).touchesBeside());
    hand_.depthControl().setDepth(2);
    EXPECT_TRUE(above(4.95).touchesBeside());
}

TEST_F(AimMarkTest, AForceCutsLessAtOnce) {
    standBeside(4.5);
    hand_.setPressMode(PressMode::Force);
    EXPECT_FALSE(above(4.95).touchesBeside());
    standBeside(4.8);
    EXPECT_TRUE(above(4.95).touchesBeside());
}

/// The hand brings a probe down into a box cavity until its floor holds the tip.
TEST(ProbedDepth, OfABoxCavityIsItsDepth) {
    DepthControl depths;
    depths.setSurface(std::make_shared<const SurfacePart>(test::box(Vec3::Constant(-5), Vec3::Constant(5))));
    for (const double depth : {0.7, 2.0, 3.3}) {
        auto cut = std::make_shared<Surface>();
        cut->base = std::make_shared<const SurfacePart>(test::blockWithCavity(Vec3(-1, -1, 5 - depth), Vec3(1, 1, 5)),
                                                        std::vector<SurfaceTag>(28, 0));
        const Instrument probe = handTool(HandInstrument::Probe);
        HapticSimulation simulation(probe.shape, 0, cut, HapticSettings());
        Tick tick;
        for (double z = 6; z > 5 - depth - 0.3; z -= 0.01) {
            tick = simulation.step({{Vec3(0.2, 0.1, z), Quat::Identity()}, 0, false}, 0.001);
        }
        EXPECT_GT(tick.contact.triangles, 0);
        const auto read = probedDepth(depths, tick.contact.proxy);
        ASSERT_TRUE(read) << depth;
        EXPECT_NEAR(*read, depth, 0.005);
    }
}

TEST(ProbedDepth, OfALeaningProbeIsLonger) {
    DepthControl depths;
    depths.setSurface(std::make_shared<const SurfacePart>(test::box(Vec3::Constant(-5), Vec3::Constant(5))));
    const double lean = 0.4;  // rad
    const Quat turn(Eigen::AngleAxisd(lean, Vec3::UnitY()));
    EXPECT_NEAR(probedDepth(depths, {Vec3(0, 0, 2), turn}).value_or(0), 3 / std::cos(lean), 1e-6);
    EXPECT_FALSE(probedDepth(depths, {Vec3(0, 0, 5.5), turn}));  // outside
    EXPECT_FALSE(probedDepth({}, {Vec3(0, 0, 2), turn}));        // nothing is known of the tooth
}

}  // namespace
}  // namespace tactooth
