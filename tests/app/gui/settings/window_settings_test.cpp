// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/settings/window_settings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "support/test_data.h"

namespace tactooth {
namespace {

WindowSettings unusual() {
    return {.geometry = "AdnQywAD",
            .docks = "AAAA/wAAAAD9",
            .folder = "/home/someone/Zähne \"neu\"",
            .bur = "58",
            .favouriteBurs = "4, 33-1/2",
            .spindle = "Micromotor, 1:1",
            .showsTurbine = false,
            .showsAim = false,
            .showsMirror = false,
            .force = {.fromMaterial = false,
                      .spring = 0.75,
                      .damper = 0.0125,
                      .scale = 1.5,
                      .press = 2.2,
                      .mouse = kMouseByForce,
                      .depth = 2.1,
                      .flatFloor = true,
                      .depthStop = true,
                      .guide = true,
                      .friction = 0.35},
            .hand = {"gamepad:Wireless", "pen:Left", 2.5, 2000, true, 3, 0, 5, "axis:2:Foot", 0.25, 0.75, "F5"},
            .sound = {.motor = 0.25, .cutting = 0.5, .master = 0.75, .muted = true, .environment = 0.125},
            .headphones = true,
            .room = false,
            .ownSounds = "/home/someone/school.toml",
            .language = "ja",
            .welcome = false,
            .dark = true,
            .recent = "/a.stl\n/b.tactooth\nscan\t/c.stl\t/d.ply",
            .notation = "palmer",
            .mirror = {"5", true, true},
            .water = false,
            .suction = true,
            .textScale = 1.5,
            .secondView = "distal",
            .recordsSessions = false,
            .recordingGigabytes = 12.5,
            .aids = {.glass = false, .scaleBar = false, .letters = false, .cube = false, .magnifier = true},
            .sideBySide = true,
            .ownKeys = "touch = F11\nfly = F12"};
}

void expectEqual(const WindowSettings& a, const WindowSettings& b) {
    EXPECT_EQ(a.geometry, b.geometry);
    EXPECT_EQ(a.docks, b.docks);
    EXPECT_EQ(a.folder, b.folder);
    EXPECT_EQ(a.bur, b.bur);
    EXPECT_EQ(a.favouriteBurs, b.favouriteBurs);
    EXPECT_EQ(a.spindle, b.spindle);
    EXPECT_EQ(a.showsTurbine, b.showsTurbine);
    EXPECT_EQ(a.showsMirror, b.showsMirror);
    EXPECT_EQ(a.showsAim, b.showsAim);
    EXPECT_EQ(a.force, b.force);
    EXPECT_EQ(a.hand, b.hand);
    EXPECT_EQ(a.sound.motor, b.sound.motor);
    EXPECT_EQ(a.sound.cutting, b.sound.cutting);
    EXPECT_EQ(a.sound.master, b.sound.master);
    EXPECT_EQ(a.sound.muted, b.sound.muted);
    EXPECT_EQ(a.sound.environment, b.sound.environment);
    EXPECT_EQ(a.headphones, b.headphones);
    EXPECT_EQ(a.room, b.room);
    EXPECT_EQ(a.ownSounds, b.ownSounds);
    EXPECT_EQ(a.language, b.language);
    EXPECT_EQ(a.welcome, b.welcome);
    EXPECT_EQ(a.dark, b.dark);
    EXPECT_EQ(a.recent, b.recent);
    EXPECT_EQ(a.notation, b.notation);
    EXPECT_EQ(a.mirror, b.mirror);
    EXPECT_EQ(a.water, b.water);
    EXPECT_EQ(a.suction, b.suction);
    EXPECT_EQ(a.textScale, b.textScale);
    EXPECT_EQ(a.secondView, b.secondView);
    EXPECT_EQ(a.recordsSessions, b.recordsSessions);
    EXPECT_EQ(a.recordingGigabytes, b.recordingGigabytes);
    EXPECT_EQ(a.aids, b.aids);
    EXPECT_EQ(a.sideBySide, b.sideBySide);
    EXPECT_EQ(a.ownKeys, b.ownKeys);
}

std::string refusal(std::string_view text) {
    const auto settings = parseWindowSettings(text, "window.toml");
    if (!settings) return settings.error().message();
    std::string sentences;
    for (const Error& refused : settings->refused) sentences += (sentences.empty() ? "" : " ") + refused.message();
    return sentences.empty() ? "accepted" : sentences;
}

TEST(WindowSettings, ComeBackAsTheyWereWritten) {
    const test::TemporaryFolder folder;
    const auto file = folder / "new folder/window.toml";
    ASSERT_TRUE(writeWindowSettings(unusual(), file).has_value());
    const auto again = readWindowSettings(file);
    ASSERT_TRUE(again.has_value()) << again.error().message();
    expectEqual(*again, unusual());
}

TEST(WindowSettings, AMotionScalingThatFitsIsWrittenAsAWord) {
    WindowSettings settings;
    settings.hand.motionScaling = kAutoScaling;
    const std::string text = windowSettingsText(settings);
    EXPECT_NE(text.find("fineness = 'fit'"), std::string::npos) << text;
    const auto again = parseWindowSettings(text, "window.toml");
    ASSERT_TRUE(again.has_value()) << again.error().message();
    EXPECT_EQ(again->hand.motionScaling, kAutoScaling);
    EXPECT_EQ(refusal("[hand]\nfineness = 0.5\n"),
              "window.toml, line 2: 'fineness' must be a number from 1 to 3, or \"fit\".");
    EXPECT_EQ(refusal("[hand]\nfineness = \"fits\"\n"),
              "window.toml, line 2: 'fineness' must be a number from 1 to 3, or \"fit\".");
}

TEST(WindowSettings, WithoutAFileTheyAreTheDefaults) {
    const test::TemporaryFolder folder;
    const auto settings = readWindowSettings(folder / "window.toml");
    ASSERT_TRUE(settings.has_value());
    expectEqual(*settings, WindowSettings());
}

TEST(WindowSettings, WhatAFileDoesNotSayKeepsItsDefaultAndUnknownKeysArePassedOver) {
    const auto settings = parseWindowSettings("[sound]\nall = 0.5\nsubwoofer = 3\n[hologram]\nx = 1\n", "window.toml");
    ASSERT_TRUE(settings.has_value()) << settings.error().message();
    WindowSettings expected;
    expected.sound.master = 0.5;
    expectEqual(*settings, expected);
}

TEST(WindowSettings, AValueThatCannotBeMeantIsRefusedWithItsLine) {
    EXPECT_EQ(refusal("[force]\nspring = -1\n"), "window.toml, line 2: 'spring' must be a number from 0 to 3.");
    EXPECT_EQ(refusal("[force]\nscale = nan\n"), "window.toml, line 2: 'scale' must be a number from 0 to 3.");
    EXPECT_EQ(refusal("[hand]\nrate = 100\n"), "window.toml, line 2: 'rate' must be a number from 500 to 4000.");
    EXPECT_EQ(refusal("[sound]\n\nall = \"loud\"\n"), "window.toml, line 3: 'all' must be a number from 0 to 1.");
    EXPECT_EQ(refusal("[sound]\nmuted = 1\n"), "window.toml, line 2: 'muted' must be true or false.");
    EXPECT_EQ(refusal("[window]\nfolder = 7\n"), "window.toml, line 2: 'folder' must be a text in quotes.");
    EXPECT_EQ(refusal("force = 2\n"), "window.toml, line 1: 'force' must be a table.");
}

TEST(WindowSettings, AValueThatCannotBeMeantCostsOnlyItself) {
    const auto settings = parseWindowSettings(
        "force = 3\n[hand]\nrate = 99\nfineness = 2\ndevice = \"pen\"\n[sound]\nall = 0.5\nmuted = \"no\"\n"
        "[window]\ndark = true\nfolder = 2\nlanguage = \"ja\"\n",
        "window.toml");
    ASSERT_TRUE(settings.has_value());
    ASSERT_EQ(settings->refused.size(), 4U) << "each is reported, and a table once";
    EXPECT_EQ(settings->hand.motionScaling, 2);
    EXPECT_EQ(settings->hand.device, "pen");
    EXPECT_EQ(settings->hand.rate, DeviceSettings().rate);
    EXPECT_EQ(settings->sound.master, 0.5);
    EXPECT_FALSE(settings->sound.muted);
    EXPECT_TRUE(settings->dark);
    EXPECT_EQ(settings->folder, "");
    EXPECT_EQ(settings->language, "ja");
    EXPECT_EQ(settings->force, ForceSettings());
}

TEST(WindowSettings, AFileThatCannotBeReadIsPutAsideAndAnOlderOneThereGoes) {
    const test::TemporaryFolder folder;
    const auto file = folder / "window.toml";
    for (const std::string text : {"one = [", "two = ["}) {
        std::ofstream(file) << text;
        const auto aside = backUpInvalidSettings(file);
        ASSERT_TRUE(aside.has_value());
        EXPECT_EQ(*aside, folder / "window.toml.bad");
        EXPECT_FALSE(std::filesystem::exists(file));
        std::string kept;
        std::getline(std::ifstream(*aside), kept);
        EXPECT_EQ(kept, text);
    }
    EXPECT_FALSE(backUpInvalidSettings(file).has_value()) << "there is none any more";
}

TEST(WindowSettings, WhatIsNotTomlIsRefusedWithItsLine) {
    EXPECT_TRUE(refusal("[window]\nfolder = \"open\n").starts_with("window.toml, line 2: this is not TOML: "));
    EXPECT_TRUE(refusal(std::string_view("\0\xff\x01", 3)).starts_with("window.toml, line 1: this is not TOML: "));
}

TEST(WindowSettings, AFolderInThePlaceOfTheFileIsRefused) {
    const test::TemporaryFolder folder;
    EXPECT_FALSE(readWindowSettings(folder.path()).has_value());
    EXPECT_FALSE(writeWindowSettings(unusual(), folder.path()).has_value());
}

TEST(WindowSettings, AnyTruncatedFileGivesSettingsOrASentence) {
    const std::string text = windowSettingsText(unusual());
    for (std::size_t length = 0; length < text.size(); ++length) {
        const auto settings = parseWindowSettings(std::string_view(text).substr(0, length), "window.toml");
        if (!settings) {
            EXPECT_TRUE(settings.error().message().starts_with("window.toml, line ")) << settings.error().message();
        }
    }
}

TEST(WindowSettings, ADeviceThatNobodyKnowsIsForgottenWithOneSentence) {
    DeviceSettings hand = unusual().hand;
    EXPECT_FALSE(resetUnknownDevices(hand, "window.toml"));
    EXPECT_EQ(hand, unusual().hand);
    hand.device = "joystick";
    EXPECT_EQ(
        resetUnknownDevices(hand, "window.toml").value().message(),
        "window.toml: Tactooth knows no device 'joystick' (device); the usual one takes its place, choose another "
        "in the panel Hand.");
    EXPECT_EQ(hand.device, "mouse");
    EXPECT_EQ(hand.secondDevice, unusual().hand.secondDevice);
    hand.device = "joystick";
    hand.secondDevice = "bogus";
    EXPECT_NE(resetUnknownDevices(hand, "window.toml")
                  .value()
                  .message()
                  .find("'joystick' (device) and no 'bogus' (second_device)"),
              std::string::npos);
    EXPECT_EQ(hand.secondDevice, "none");
}

const WindowOption& optionCalled(const std::string& flag) {
    const auto all = windowOptions();
    return *std::find_if(all.begin(), all.end(), [&](const WindowOption& option) { return flagOf(option) == flag; });
}

std::string setOption(WindowSettings& settings, const std::string& flag, const std::string& text) {
    const auto done = setWindowOption(settings, optionCalled(flag), text);
    return done ? "" : done.error().message();
}

TEST(WindowSettings, EachIsAFlagToo) {
    WindowSettings settings;
    EXPECT_EQ(setOption(settings, "--force-spring", "0.5"), "");
    EXPECT_EQ(setOption(settings, "--force-from-material", "no"), "");
    EXPECT_EQ(setOption(settings, "--hand-fineness", "2.5"), "");
    EXPECT_EQ(settings.hand.motionScaling, 2.5);
    EXPECT_EQ(setOption(settings, "--hand-fineness", "fit"), "");
    EXPECT_EQ(settings.hand.motionScaling, kAutoScaling);
    EXPECT_EQ(setOption(settings, "--window-language", "ja"), "");
    EXPECT_EQ(settings.force.spring, 0.5);
    EXPECT_FALSE(settings.force.fromMaterial);
    EXPECT_EQ(settings.language, "ja");
}

TEST(WindowSettings, AWordThatAFileCannotMeanIsRefusedWithItsLine) {
    const auto settings = parseWindowSettings("[force]\nmouse = \"deep\"\n[window]\nlanguage = \"ja\"\n", "w.toml");
    ASSERT_TRUE(settings);
    ASSERT_EQ(settings->refused.size(), 1U);
    const std::string sentence = settings->refused[0].message();
    EXPECT_NE(sentence.find("line 2"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("one of depth, force"), std::string::npos) << sentence;
    EXPECT_EQ(settings->force.mouse, WindowSettings().force.mouse);
    EXPECT_EQ(settings->language, "ja");
}

TEST(WindowSettings, AFlagThatCannotBeMeantIsRefused) {
    WindowSettings settings;
    EXPECT_EQ(setOption(settings, "--force-spring", "4"), "--force-spring takes a number from 0 to 3, not '4'.");
    EXPECT_EQ(setOption(settings, "--hand-rate", "300"), "--hand-rate takes a number from 500 to 4000, not '300'.");
    EXPECT_EQ(setOption(settings, "--hand-fineness", "0"),
              "--hand-fineness takes fit or a number from 1 to 3, not '0'.");
    EXPECT_EQ(setOption(settings, "--hand-rate", "fit"), "--hand-rate takes a number from 500 to 4000, not 'fit'.");
    EXPECT_EQ(setOption(settings, "--force-damper", "x"), "--force-damper takes a number from 0 to 0.02, not 'x'.");
    EXPECT_EQ(setOption(settings, "--force-mouse", "deep"), "--force-mouse takes one of depth, force, not 'deep'.");
    EXPECT_EQ(setOption(settings, "--window-language", "de"), "--window-language takes one of en, ja, not 'de'.");
    EXPECT_EQ(setOption(settings, "--mirror-size", "3"), "--mirror-size takes one of 2, 4, 5, not '3'.");
    EXPECT_EQ(setOption(settings, "--window-second-view", "mesia"),
              "--window-second-view takes one of occlusal, buccal, lingual, mesial, distal, none, not 'mesia'.");
    EXPECT_EQ(settings.force.mouse, WindowSettings().force.mouse);
    EXPECT_EQ(setOption(settings, "--window-dark", "1"), "--window-dark takes yes or no, not '1'.");
    EXPECT_EQ(settings.force.spring, WindowSettings().force.spring);
    EXPECT_FALSE(settings.dark);
}

}  // namespace
}  // namespace tactooth
