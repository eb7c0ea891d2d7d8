// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/haply/haply_message.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace tactooth {
namespace {

using ::testing::HasSubstr;

constexpr const char* kTwoArms =
    R"({"session_id":3,"inverse3":[{"device_id":"049D","config":{},"state":{"cursor_position":{"x":0,"y":0,"z":0}}},)"
    R"({"device_id":"0B1C","state":{"cursor_position":{"x":0,"y":0,"z":0}}}],)"
    R"("verse_grip":[{"device_id":"V1"}],"wireless_verse_grip":[{"device_id":"61576"}]})";

std::string messageWith(const std::string& place, const std::string& status = "{}", const std::string& grip = "") {
    return R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":)" + place + R"(},"status":)" + status +
           R"(}],"wireless_verse_grip":[)" + grip + "]}";
}

HaplyReading readingOf(const std::string& message) {
    const auto reading = readHaply(message, {"049D", "61576"});
    EXPECT_TRUE(reading) << (reading ? "" : reading.error().message());
    return reading ? *reading : HaplyReading();
}

std::string errorOf(const std::string& message) {
    const auto reading = readHaply(message, {"049D", "61576"});
    return reading ? "" : reading.error().message();
}

constexpr const char* kMiddle = R"({"x":0.01,"y":-0.02,"z":0.15})";

TEST(HaplyMessage, EachArmHasTheGripOfItsOwnNumberThoseWithACableFirst) {
    const auto devices = haplyDevices(kTwoArms);
    ASSERT_TRUE(devices);
    ASSERT_EQ(devices->size(), 2U);
    EXPECT_EQ((*devices)[0].device, "049D");
    EXPECT_EQ((*devices)[0].grip, "V1");
    EXPECT_EQ((*devices)[1].device, "0B1C");
    EXPECT_EQ((*devices)[1].grip, "61576");
}

TEST(HaplyMessage, AnArmIsFoundByItsNameAndTheFirstWithoutOne) {
    EXPECT_EQ(findHaply(kTwoArms, "").value().device, "049D");
    EXPECT_EQ(findHaply(kTwoArms, "0B1C").value().grip, "61576");
    const auto none = findHaply(kTwoArms, "FFFF");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().message(), "The Haply Inverse Service knows no Inverse3 'FFFF': it finds 049D, 0B1C.");
    EXPECT_THAT(findHaply(R"({"inverse3":[]})", "").error().message(), HasSubstr("check its cable and power supply"));
}

TEST(HaplyMessage, MetresBecomeMillimetresAndAxesStay) {
    const HaplyReading reading = readingOf(messageWith(kMiddle));
    EXPECT_EQ(reading.hand.position, Vec3(10, -20, 150));
    EXPECT_EQ(reading.hand.rotation.coeffs(), Quat::Identity().coeffs()) << "there is no grip";
    EXPECT_TRUE(reading.usable);
    EXPECT_EQ(reading.faultMessage, nullptr);
}

TEST(HaplyMessage, TheGripTurnsTheHandAndPressesItsButtons) {
    const double half = std::numbers::pi / 4;  // a quarter rotation about the vertical axis: right becomes away
    const std::string quarter = R"({"device_id":"61576","state":{"orientation":{"w":)" +
                                std::to_string(std::cos(half)) + R"(,"x":0,"y":0,"z":)" +
                                std::to_string(std::sin(half)) + R"(},"buttons":{"a":true,"b":false,"c":true}}})";
    const HaplyReading reading = readingOf(messageWith(kMiddle, "{}", quarter));
    EXPECT_LT((reading.hand.rotation * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-5);
    EXPECT_NEAR(reading.hand.rotation.norm(), 1, 1e-12);
    EXPECT_EQ(reading.buttons, 5U);
    const std::string numbered = R"({"device_id":"61576","state":{"buttons":{"button_1":true}}})";
    EXPECT_EQ(readingOf(messageWith(kMiddle, "{}", numbered)).buttons, 2U);
}

TEST(HaplyMessage, AGripThatReportsNoRotationTurnsNothing) {
    for (const char* const state :
         {R"({"orientation":7})", R"({"orientation":null})", R"({"orientation":[1,0,0,0]})", "{}", "7"}) {
        const std::string grip = std::string(R"({"device_id":"61576","state":)") + state + "}";
        const HaplyReading reading = readingOf(messageWith(kMiddle, "{}", grip));
        EXPECT_EQ(reading.hand.rotation.coeffs(), Quat::Identity().coeffs());
        EXPECT_FALSE(reading.hasTurn);
        EXPECT_TRUE(reading.usable);
    }
}

TEST(HaplyMessage, FourNumbersThatAreNoTurnAreAFaultAndNotAnotherTurn) {
    for (const char* const turn :
         {R"("w":0,"x":0,"y":0,"z":0)", R"("w":null,"x":0,"y":0,"z":0)", R"("w":1,"x":0,"y":0)",
          R"("w":0.9,"x":0,"y":0,"z":0)", R"("w":1.1,"x":0,"y":0,"z":0)", R"("w":1e200,"x":1e200,"y":0,"z":0)",
          R"("w":"1","x":0,"y":0,"z":0)"}) {
        const std::string grip = std::string(R"({"device_id":"61576","state":{"orientation":{)") + turn + "}}}";
        const HaplyReading reading = readingOf(messageWith(kMiddle, "{}", grip));
        EXPECT_FALSE(reading.usable) << turn;
        ASSERT_NE(reading.faultMessage, nullptr);
        EXPECT_THAT(reading.faultMessage->in(Language::English), HasSubstr("an orientation that is not valid"));
    }
    const std::string rounded = R"({"device_id":"61576","state":{"orientation":{"w":0.7,"x":0.71,"y":0.0,"z":0.04}}})";
    EXPECT_TRUE(readingOf(messageWith(kMiddle, "{}", rounded)).hasTurn) << "text may be rounded";
}

TEST(HaplyMessage, EachStateThatKeepsItFromWorkingHasItsSentence) {
    const auto expectFault = [](const std::string& message, const char* part, bool usable) {
        const HaplyReading reading = readingOf(message);
        ASSERT_NE(reading.faultMessage, nullptr) << part;
        EXPECT_THAT(reading.faultMessage->in(Language::English), HasSubstr(part));
        EXPECT_EQ(reading.usable, usable) << part;
    };
    expectFault(messageWith(kMiddle, R"({"power_supply":false})"), "plug in its power supply", false);
    expectFault(messageWith(kMiddle, R"({"calibrated":false})"), "rest position until its light", false);
    expectFault(messageWith(kMiddle, R"({"ready":false})"), "is not ready", false);
    expectFault(messageWith(R"({"x":null,"y":0,"z":0})"), "has lost its position", false);
    expectFault(messageWith(R"({"x":0,"y":0})"), "has lost its position", false);
    expectFault(messageWith(kMiddle, "{}", R"({"device_id":"61576","status":{"awake":false}})"),
                "press one of its buttons", true);
}

TEST(HaplyMessage, WhatCannotBeMeantIsRefusedWithItsSentence) {
    EXPECT_THAT(errorOf(R"({"inverse3":[{"device_)"), HasSubstr("messages that cannot be read"));
    EXPECT_THAT(errorOf("[1,2]"), HasSubstr("messages that cannot be read"));
    EXPECT_THAT(errorOf(messageWith(R"({"x":NaN,"y":0,"z":0})")), HasSubstr("messages that cannot be read"));
    EXPECT_THAT(errorOf(R"({"devices":[]})"), HasSubstr("install version 3"));
    EXPECT_THAT(errorOf(R"({"version":"2.1.0","inverse3":[]})"), HasSubstr("install version 3"));
    EXPECT_THAT(errorOf(messageWith("[0.1,0.2,0.3]")), HasSubstr("install version 3"));
    EXPECT_THAT(errorOf(messageWith(R"({"x":10,"y":-20,"z":150})")), HasSubstr("not in metres"));
    EXPECT_THAT(errorOf(R"({"inverse3":[{"device_id":"0B1C"}]})"), HasSubstr("is gone"));
    EXPECT_THAT(haplyDevices(R"({"inverse3":[{"device_id":"a\"b"}]})").error().message(),
                HasSubstr("install version 3"));
    EXPECT_EQ(errorOf(R"({"version":"3.1.2",)" + messageWith(kMiddle).substr(1)), "");
}

TEST(HaplyMessage, AForceIsWrittenAsTheServiceReadsIt) {
    EXPECT_EQ(
        haplyForce("049D", Vec3(0.5, 0, -1.25)),
        R"({"inverse3":[{"device_id":"049D","commands":{"set_cursor_force":{"values":{"x":0.5,"y":0,"z":-1.25}}}}]})");
    EXPECT_EQ(haplyHandshake("049D"), R"({"session":{"configure":{"profile":{"name":"org.tactooth:tactooth"}}},)" +
                                          haplyForce("049D", Vec3::Zero()).substr(1));
}

TEST(HaplyMessage, NoTextWhateverBreaksTheReader) {
    std::mt19937 random(7);
    const std::string good = messageWith(kMiddle, R"({"ready":true})",
                                         R"({"device_id":"61576","state":{"orientation":{"w":1,"x":0,"y":0,"z":0}}})");
    const std::string letters = "{}[]\",:0e-9.xnull\\";
    int read = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text = good;
        for (unsigned changes = 1 + random() % 3; changes > 0; --changes) {
            text[random() % text.size()] = letters[random() % letters.size()];
        }
        const auto reading = readHaply(text, {"049D", "61576"});
        if (!reading) continue;
        ++read;
        if (reading->usable) {
            EXPECT_LE(reading->hand.position.cwiseAbs().maxCoeff(), 1000);
        }
        EXPECT_NEAR(reading->hand.rotation.norm(), 1, 1e-9);
    }
    EXPECT_GT(read, 100) << "some changes leave a message";
}

}  // namespace
}  // namespace tactooth
