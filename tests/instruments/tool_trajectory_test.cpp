// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/tool_trajectory.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace tactooth {
namespace {

TEST(ToolTrajectory, BeginsAndEndsAboveThePlateAndPressesInBetween) {
    const TriangleMesh plate = test::box(Vec3(-9, -9, -5), Vec3(9, 9, 0));
    ToolTrajectory path;
    path.press = 0.25;
    path.approach = 0.6;
    const std::vector<Pose> hand = toolTrajectory(plate, path);
    EXPECT_NEAR(hand.front().position.z(), 0.6, 1e-9);
    EXPECT_GT(hand.back().position.z(), 0.55);
    const auto lowest = std::ranges::min_element(hand, {}, [](const Pose& p) { return p.position.z(); });
    EXPECT_NEAR(lowest->position.z(), -0.25, 1e-9);
}

TEST(ToolTrajectory, MovesAtItsSpeedAndTurnsAtItsRate) {
    const TriangleMesh plate = test::box(Vec3(-9, -9, -5), Vec3(9, 9, 0));
    ToolTrajectory path;
    path.speed = 50;
    path.turn = 60;
    const std::vector<Pose> hand = toolTrajectory(plate, path);
    ASSERT_GT(hand.size(), 100U);
    for (std::size_t i = 1; i < hand.size(); ++i) {
        EXPECT_LT((hand[i].position - hand[i - 1].position).norm(), 0.05 + 1e-9);  // shorter at a bend of the path
        EXPECT_LT(hand[i].rotation.angularDistance(hand[i - 1].rotation) * 180 / 3.14159265, 0.06 + 1e-6);
    }
    EXPECT_NEAR((hand[2].position - hand[1].position).norm(), 0.05, 1e-9);
    EXPECT_NEAR(hand[2].rotation.angularDistance(hand[1].rotation) * 180 / 3.14159265, 0.06, 1e-6);
}

}  // namespace
}  // namespace tactooth
