// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/pad_mapping.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tactooth {
namespace {

TEST(PadMapping, AStickHasADeadZoneAroundItsMiddle) {
    EXPECT_EQ(applyStickDeadZone({0.14, 0})[0], 0);
    EXPECT_EQ(applyStickDeadZone({-0.1, 0.1})[1], 0);
    EXPECT_GT(applyStickDeadZone({0.16, 0})[0], 0);
    EXPECT_LT(applyStickDeadZone({0.16, 0})[0], 0.01) << "and does not jump behind it";
    EXPECT_NEAR(applyStickDeadZone({1, 0})[0], 1, 1e-12);
    EXPECT_NEAR(applyStickDeadZone({0, -1})[1], -1, 1e-12);
}

TEST(PadMapping, AStickKeepsItsDirectionAndIsNeverFasterThanItsEnd) {
    for (double angle = 0; angle < 6.28; angle += 0.1) {
        for (const double deflection : {0.3, 0.8, 1.0, 1.41}) {
            const auto value = applyStickDeadZone({deflection * std::cos(angle), deflection * std::sin(angle)});
            EXPECT_NEAR(std::atan2(value[1], value[0]), std::remainder(angle, 2 * M_PI), 1e-9);
            EXPECT_LE(std::hypot(value[0], value[1]), 1 + 1e-12);
        }
    }
}

TEST(PadMapping, AStickIsFineNearItsMiddle) {
    EXPECT_LT(applyStickDeadZone({0.575, 0})[0], 0.35) << "half of the travel beyond the dead zone";
}

TEST(PadMapping, ATriggerGoesFromItsDeadZoneToItsEnd) {
    EXPECT_EQ(applyTriggerDeadZone(-1), 0);
    EXPECT_EQ(applyTriggerDeadZone(0.03), 0);
    EXPECT_NEAR(applyTriggerDeadZone(0.52), 0.5, 1e-12);
    EXPECT_EQ(applyTriggerDeadZone(1), 1);
}

TEST(PadMapping, EachPartMovesWhatItShould) {
    PadState pad;
    EXPECT_EQ(padCommand(pad, false).rate.speed, Vec3::Zero());
    pad.leftStick = {1, 0};
    EXPECT_NEAR(padCommand(pad, false).rate.speed.x(), 25, 1e-9) << "right";
    pad.leftStick = {0, -1};
    EXPECT_NEAR(padCommand(pad, false).rate.speed.y(), 25, 1e-9) << "pushed away";
    pad = {};
    pad.leftTrigger = 1;
    EXPECT_NEAR(padCommand(pad, false).rate.speed.z(), -25, 1e-9) << "presses";
    pad = {};
    pad.lift = true;
    EXPECT_GT(padCommand(pad, false).rate.speed.z(), 20);
    pad = {};
    pad.rightStick = {1, 0};
    EXPECT_GT(padCommand(pad, false).rate.turn.y(), 1) << "the shaft's end goes right";
    pad.rightStick = {0, -1};
    EXPECT_LT(padCommand(pad, false).rate.turn.x(), -1) << "the shaft's end goes away";
    pad = {};
    pad.rightTrigger = 1;
    EXPECT_EQ(padCommand(pad, false).pedal, 1);
}

TEST(PadMapping, LeftHandedIsTheOtherWayRound) {
    PadState pad;
    pad.rightStick = {1, 0};
    pad.leftTrigger = 1;
    const PadCommand wish = padCommand(pad, true);
    EXPECT_NEAR(wish.rate.speed.x(), 25, 1e-9);
    EXPECT_EQ(wish.rate.speed.z(), 0);
    EXPECT_EQ(wish.pedal, 1);
    EXPECT_EQ(wish.rate.turn, Vec3::Zero());
}

}  // namespace
}  // namespace tactooth
