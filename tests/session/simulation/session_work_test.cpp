// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/session_work.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tactooth {
namespace {

SessionWork someWork() {
    return {.title = "Pit \"46\"",
            .exercise = "Pit in the molar",
            .exerciseFile = "/home/somebody/course/pit.toml",
            .targetFile = "/home/somebody/ideal.stl",
            .bur = "Round 1.4 mm",
            .burFile = "/home/somebody/bur.stl",
            .mouthTooth = 46,
            .seconds = 75.25,
            .events = {{CutEventKind::FirstContact, 2.5, Vec3(1, 2, 3), false},
                       {CutEventKind::DentinReached, 40, Vec3(-1, 0, 0.1), true}},
            .isUnsaved = true};
}

TEST(SessionWork, ComesBackFromItsText) {
    const SessionWork work = someWork();
    const auto read = parseWork(workText(work));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->title, work.title);
    EXPECT_EQ(read->exercise, work.exercise);
    EXPECT_EQ(read->exerciseFile, work.exerciseFile);
    EXPECT_EQ(read->targetFile, work.targetFile);
    EXPECT_EQ(read->bur, work.bur);
    EXPECT_EQ(read->burFile, work.burFile);
    EXPECT_EQ(read->mouthTooth, 46);
    EXPECT_EQ(read->seconds, 75.25);
    EXPECT_TRUE(read->isUnsaved);
    ASSERT_EQ(read->events.size(), 2U);
    EXPECT_EQ(read->events[1].kind, CutEventKind::DentinReached);
    EXPECT_EQ(read->events[1].time, 40);
    EXPECT_EQ(read->events[1].place, Vec3(-1, 0, 0.1));
    EXPECT_TRUE(read->events[1].isTakenBack);
    EXPECT_FALSE(read->events[0].isTakenBack);
}

TEST(SessionWork, AFileToHandOnNamesNoFolder) {
    const std::string text = workTextWithoutFolders(someWork());
    EXPECT_EQ(text.find("somebody"), std::string::npos) << text;
    const auto read = parseWork(text);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->exerciseFile, "pit.toml");
    EXPECT_EQ(read->targetFile, "ideal.stl");
    EXPECT_FALSE(read->isUnsaved);
}

TEST(SessionWork, WhatIsNoTextOfItIsNothing) {
    for (const char* text : {"", "{", "[]", "3", "null"}) EXPECT_FALSE(parseWork(text)) << text;
    EXPECT_TRUE(parseWork("{}"));
    EXPECT_FALSE(parseWork(std::string(kMaxWorkBytes + 1, ' ') + "{}"));
}

TEST(SessionWork, DamagedValuesKeepTheirDefaults) {
    const auto read = parseWork(
        R"({"title":3,"seconds":-1,"mouth_tooth":1e300,"events":[{"what":"first contact","t":1e300,"x":0,"y":0,"z":0},
        {"what":"nothing","t":1,"x":0,"y":0,"z":0},{"what":"pulp exposed","t":9,"x":0,"y":0,"z":0},
        {"what":"pulp exposed","t":3,"x":0,"y":0,"z":0}]})");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->title, "");
    EXPECT_EQ(read->mouthTooth, 0);
    ASSERT_EQ(read->events.size(), 1U) << "and their times rise";
    EXPECT_EQ(read->seconds, 9) << "the session is as long as its events";
}

TEST(SessionWork, AnyBytesAreReadWithoutHarm) {
    std::mt19937 random(3);
    const std::string whole = workText(someWork());
    for (int i = 0; i < 3000; ++i) {
        std::string text = whole;
        for (int changes = 0; changes < 4; ++changes) text[random() % text.size()] = static_cast<char>(random());
        const auto read = parseWork(text);
        if (!read) continue;
        EXPECT_TRUE(std::isfinite(read->seconds));
        for (const CutEvent& event : read->events) EXPECT_TRUE(event.place.allFinite() && std::isfinite(event.time));
    }
}

}  // namespace
}  // namespace tactooth
