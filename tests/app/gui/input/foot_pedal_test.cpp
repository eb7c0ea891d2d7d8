// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/input/foot_pedal.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

#include "devices/virtual_pad.h"

namespace tactooth {
namespace {

using Kind = PedalBinding::Kind;

bool soon(const std::function<bool()>& condition) {
    for (int i = 0; i < 6000; ++i) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

TEST(FootPedal, WithoutOneTheFootIsOff) {
    FootPedal pedal;
    EXPECT_EQ(pedal.step(), 0);
    EXPECT_TRUE(pedal.choose({Kind::Axis, 0, "no such joystick"}));
    EXPECT_EQ(pedal.step(), 0);
}

TEST(FootPedal, FollowsTheAxisThatWasChosen) {
    test::VirtualPad foot("Foot Switch", SDL_JOYSTICK_TYPE_UNKNOWN);
    FootPedal pedal;
    ASSERT_TRUE(pedal.choose({Kind::Axis, 1, "Foot"}));
    foot.axis(1, 1);
    EXPECT_TRUE(soon([&] { return pedal.step() == 1; }));
    foot.axis(1, -1);
    EXPECT_TRUE(soon([&] { return pedal.step() == 0; }));
}

TEST(FootPedal, LearnsThePedalFromAFoot) {
    test::VirtualPad foot("Foot Switch", SDL_JOYSTICK_TYPE_UNKNOWN);
    foot.axis(3, 0.8);
    FootPedal pedal;
    ASSERT_TRUE(pedal.setCalibrating(true));
    EXPECT_TRUE(pedal.isCalibrating());
    const auto play = [&](double to) {
        foot.axis(3, to);
        for (int i = 0; i < 30; ++i) {
            EXPECT_EQ(pedal.step(), 0) << "the foot shows the pedal, it does not drill";
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    };
    play(0.8);
    play(-0.9);
    play(0.8);
    EXPECT_TRUE(soon([&] { return (void)pedal.step(), !pedal.isCalibrating(); }));
    EXPECT_EQ(pedalText(pedal.choice()), "axis:3:Foot Switch");
    EXPECT_NEAR(pedal.choice().up, 0.9, 0.01);
    EXPECT_NEAR(pedal.choice().down, 0.05, 0.01);
    foot.axis(3, -0.9);
    EXPECT_TRUE(soon([&] { return pedal.step() == 1; }));
}

}  // namespace
}  // namespace tactooth
