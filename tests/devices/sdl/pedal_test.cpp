// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/sdl/pedal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "virtual_pad.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;
using Kind = PedalBinding::Kind;

JoystickState joystick(const std::string& name, std::vector<double> axes, std::vector<bool> buttons = {}) {
    return {name, false, false, std::move(axes), std::move(buttons)};
}

TEST(Pedal, IsNamedByAxisOrButtonAndJoystick) {
    EXPECT_EQ(*parsePedal(""), PedalBinding{});
    EXPECT_EQ(*parsePedal("axis:2"), (PedalBinding{Kind::Axis, 2, ""}));
    EXPECT_EQ(*parsePedal("button:0:Foot: Switch"), (PedalBinding{Kind::Button, 0, "Foot: Switch"}));
    for (const char* text : {"", "axis:2", "button:31:Foot: Switch"}) EXPECT_EQ(pedalText(*parsePedal(text)), text);
}

TEST(Pedal, WhatIsNoneIsRefusedWithASentence) {
    for (const char* text : {"axis", "axis:", "axis:-1", "axis:32", "axis:1.5", "pedal:0", ":", "axis:x:Name"}) {
        const auto choice = parsePedal(text);
        ASSERT_FALSE(choice) << text;
        EXPECT_THAT(choice.error().message(), ::testing::HasSubstr("axis:N or button:N"));
    }
}

TEST(Pedal, AnAxisGoesBetweenItsTwoEnds) {
    PedalBinding choice{Kind::Axis, 1, "", 0.2, 0.8};
    const auto at = [&](double value) {
        const std::vector<JoystickState> one = {joystick("Foot", {0, value})};
        return pedalOf(choice, one);
    };
    EXPECT_EQ(at(0.1), 0);
    EXPECT_EQ(at(0.22), 0) << "a foot that rests on it";
    EXPECT_NEAR(*at(0.5), 0.5, 1e-12);
    EXPECT_EQ(at(0.79), 1);
    std::swap(choice.up, choice.down);
    EXPECT_EQ(at(0.9), 0) << "and the other way round";
    EXPECT_EQ(at(0.2), 1);
    choice.down = choice.up;
    EXPECT_EQ(at(0.5), 0) << "an axis without travel";
}

TEST(Pedal, IsFoundByNameAndMissedWhenItIsNotThere) {
    const std::vector<JoystickState> two = {joystick("Wheel", {1}, {true}),
                                            joystick("Foot Switch", {0}, {false, true})};
    EXPECT_EQ(pedalOf({Kind::Axis, 0, "Foot"}, two), 0);
    EXPECT_EQ(pedalOf({Kind::Axis, 0, ""}, two), 1);
    EXPECT_EQ(pedalOf({Kind::Button, 1, ""}, two), 1) << "the first that has such a button";
    EXPECT_EQ(pedalOf({Kind::Button, 0, "Foot"}, two), 0);
    EXPECT_EQ(pedalOf({Kind::Axis, 3, ""}, two), std::nullopt);
    EXPECT_EQ(pedalOf({Kind::Axis, 0, "Hand"}, two), std::nullopt);
    EXPECT_EQ(pedalOf({}, two), std::nullopt);
}

TEST(PedalCalibrator, TakesTheAxisThatWasPressedAndLetGo) {
    PedalCalibrator teacher;
    const auto update = [&](double pedal, double noise) {
        const std::vector<JoystickState> one = {joystick("Foot", {0.5 + noise, pedal})};
        return teacher.update(one);
    };
    EXPECT_FALSE(update(0.9, 0));
    EXPECT_FALSE(update(0.5, 0.1));
    EXPECT_FALSE(update(0.15, 0));
    EXPECT_FALSE(update(0.3, 0.05));
    const auto taught = update(0.88, 0);
    ASSERT_TRUE(taught);
    EXPECT_EQ(*taught, (PedalBinding{Kind::Axis, 1, "Foot", 0.9, 0.15}));
}

TEST(PedalCalibrator, TakesAButtonAndBeginsAnewWhenSomethingIsPluggedIn) {
    PedalCalibrator teacher;
    const std::vector<JoystickState> pressed = {joystick("Foot", {}, {false, true})};
    const std::vector<JoystickState> up = {joystick("Foot", {}, {false, false})};
    EXPECT_FALSE(teacher.update({}));
    EXPECT_FALSE(teacher.update(up));
    EXPECT_FALSE(teacher.update(pressed));
    const auto taught = teacher.update(up);
    ASSERT_TRUE(taught);
    EXPECT_EQ(*taught, (PedalBinding{Kind::Button, 1, "Foot"}));
}

TEST(Pedal, ARealJoystickIsReadWithItsAxesAndButtons) {
    test::VirtualPad foot("Foot Switch", SDL_JOYSTICK_TYPE_UNKNOWN);
    const auto joysticks = SdlJoysticks::shared();
    ASSERT_TRUE(joysticks);
    foot.axis(2, 1);
    foot.button(1, true);
    const auto seen = [&](const PedalBinding& choice, double value) {
        for (int i = 0; i < 12'000; ++i) {
            const auto states = (*joysticks)->states();
            if (pedalOf(choice, states) == value) return true;
            std::this_thread::sleep_for(5ms);
        }
        return false;
    };
    EXPECT_TRUE(seen({Kind::Axis, 2, "Foot"}, 1));
    EXPECT_TRUE(seen({Kind::Button, 1, "Foot"}, 1));
    foot.axis(2, -1);
    EXPECT_TRUE(seen({Kind::Axis, 2, "Foot"}, 0));
    EXPECT_EQ((*joysticks)->states().size(), 1U);
    EXPECT_EQ((*joysticks)->states().front().axes.size(), 6U);
}

}  // namespace
}  // namespace tactooth
