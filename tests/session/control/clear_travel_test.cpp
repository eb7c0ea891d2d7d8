// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/clear_travel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "devices/mouse/mouse_device.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kStep = 0.016;  // s between two steps of the window
constexpr int kTicks = 16;       // of the servo in a step
constexpr double kRadius = 0.5;

std::shared_ptr<const ToolShape> pin() {
    return std::make_shared<const ToolShape>(test::cylinder(Vec3::Zero(), kRadius, 12, 24));
}

/// A tooth, 10 mm wide with its top at 5 mm, and a neighbour beside it that is 3 mm higher.
std::shared_ptr<const Surface> twoTeeth() {
    auto surface = std::make_shared<Surface>();
    surface->base = std::make_shared<const SurfacePart>(test::box(Vec3(-5, -5, -10), Vec3(5, 5, 5)));
    surface->patches = {std::make_shared<const SurfacePart>(test::box(Vec3(5.5, -5, -10), Vec3(8, 5, 8)))};
    return surface;
}

Pose at(const Vec3& place) { return {place, Quat::Identity()}; }

/// The tool follows the device as the mouse's does.
class ClearTravelTest : public testing::Test {
protected:
    explicit ClearTravelTest(const Vec3& start = Vec3(0, 0, 7))
        : sent_(at(start)), mouse_(sent_), query_(pin(), twoTeeth()) {
        travel_.setTool(pin());
        travel_.setSurface(twoTeeth());
    }
    /// One step toward `goal`; returns whether the tool was free at each tick of it.
    bool step(const Pose& goal) {
        travel_.goTo({sent_, tool_}, goal);
        sent_ = travel_.advance({sent_, tool_}, kStep);
        mouse_.moveTo({sent_, 0, 0, true});
        bool isFree = true;
        for (int i = 0; i < kTicks; ++i) {
            tool_ = mouse_.read(0.001).hand;
            isFree = isFree && query_.isFree(tool_);
        }
        return isFree;
    }

    ClearTravel travel_;
    Pose sent_;
    MouseDevice mouse_;
    Pose tool_ = sent_;
    ContactQuery query_;
};

TEST_F(ClearTravelTest, InFreeSpaceItGoesStraight) {
    const Vec3 goal(3, 2, 7);
    int steps = 0;
    for (; steps < 100 && (tool_.position - goal).norm() > 0.01; ++steps) {
        EXPECT_TRUE(step(at(goal)));
        EXPECT_NEAR(tool_.position.x() * 2, tool_.position.y() * 3, 1e-9);
    }
    EXPECT_LT(steps, 15) << "a quarter of a second";
    EXPECT_TRUE(travel_.hasArrived());
}

TEST_F(ClearTravelTest, AGoalThatIsNotClearIsRisenAlongTheShaft) {
    for (int i = 0; i < 60; ++i) EXPECT_TRUE(step(at(Vec3(1, 1, 4))));
    EXPECT_NEAR(tool_.position.x(), 1, 1e-3);
    EXPECT_GT(tool_.position.z(), 5 + 0.7 * ClearTravel::kClearance);
    EXPECT_LT(tool_.position.z(), 5 + 2.5 * ClearTravel::kClearance);
}

TEST_F(ClearTravelTest, OverATallNeighbourItRisesGoesAcrossAndComesDown) {
    const Vec3 goal(10, 0, 4);
    double highest = 0;
    for (int i = 0; i < 80; ++i) {
        EXPECT_TRUE(step(at(goal))) << tool_.position.transpose();
        highest = std::max(highest, tool_.position.z());
    }
    EXPECT_LT((tool_.position - goal).norm(), 0.01);
    EXPECT_GT(highest, 8);
}

TEST_F(ClearTravelTest, ToNowhereItStays) {
    travel_.setSurface(std::make_shared<Surface>(
        Surface{.base = std::make_shared<const SurfacePart>(test::box(Vec3(-50, -50, -10), Vec3(50, 50, 60)))}));
    EXPECT_FALSE(travel_.risen(at(Vec3(0, 0, 7))));
    const Pose before = sent_;
    for (int i = 0; i < 5; ++i) (void)step(at(Vec3(3, 0, 7)));
    EXPECT_EQ(sent_.position, before.position);
}

TEST_F(ClearTravelTest, AToolInACavityLeavesAlongItsShaftFirst) {
    sent_ = tool_ = at(Vec3(4.8, 0, 4));  // 1 mm deep at the edge of the tooth
    mouse_.moveTo({sent_, 0, 0, true});
    for (int i = 0; i < 1000; ++i) tool_ = mouse_.read(0.001).hand;
    const Pose goal = at(Vec3(-3, 0, 6));
    travel_.goTo({sent_, tool_, true}, goal);
    double aside = 0;
    while (tool_.position.z() < 5) {
        (void)step(goal);
        if (tool_.position.z() < 5) aside = std::max(aside, std::abs(tool_.position.x() - 4.8));
    }
    EXPECT_LT(aside, 0.02);
    for (int i = 0; i < 60; ++i) (void)step(goal);
    EXPECT_LT((tool_.position - goal.position).norm(), 0.01);
}

/// A goal that moves on all the time, as under a mouse that is never still.
TEST_F(ClearTravelTest, NoRandomMouseMakesItTouchAnything) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> x(-9, 12), y(-9, 9), z(-2, 9), angle(-0.5, 0.5), part(0, 1);
    int reached = 0, high = 0;
    Pose goal = at(Vec3(0, 0, 7));
    for (int i = 0; i < 6000; ++i) {
        if (i % 30 == 0) {
            goal = {Vec3(x(random), y(random), z(random)),
                    Quat(Eigen::AngleAxisd(angle(random), Vec3(part(random), part(random), 0.1).normalized()))};
        } else if (i % 2 == 0) {
            goal.position += Vec3(part(random) - 0.5, part(random) - 0.5, 0) * 0.3;
        }
        EXPECT_TRUE(step(goal)) << "step " << i << " at " << tool_.position.transpose();
        reached += travel_.hasArrived() ? 1 : 0;
        high += tool_.position.z() > 8.2 ? 1 : 0;
    }
    EXPECT_GT(reached, 2000) << "it arrives";
    EXPECT_GT(high, 300) << "it had to go over the neighbour";
}

TEST_F(ClearTravelTest, WithoutSceneItGoesStraight) {
    ClearTravel free;
    const Pose from = at(Vec3::Zero());
    free.goTo({from, from}, at(Vec3(1, 0, 0)));
    EXPECT_NEAR(free.advance({from, from}, 1e-3).position.x(), ClearTravel::kSpeed * 1e-3, 1e-12);
    EXPECT_NEAR(free.advance({from, from}, 1).position.x(), 1, 1e-12);
}

}  // namespace
}  // namespace tactooth
