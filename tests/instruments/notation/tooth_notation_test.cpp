// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/notation/tooth_notation.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "instruments/builtin_tooth.h"

namespace tactooth {
namespace {

constexpr std::array kNotations = {ToothNotation::Fdi, ToothNotation::Universal, ToothNotation::Palmer};

std::vector<int> permanentTeeth() {
    std::vector<int> all;
    for (int fdi = 11; fdi <= 48; ++fdi) {
        if (isPermanentTooth(fdi)) all.push_back(fdi);
    }
    return all;
}

TEST(ToothNotation, EachTextNamesTheToothThatItWasMadeFrom) {
    for (const ToothNotation notation : kNotations) {
        std::set<std::string> texts;
        for (const int fdi : permanentTeeth()) {
            const std::string text = toothLabel(fdi, notation);
            EXPECT_EQ(toothNamed(text, notation), fdi) << text;
            texts.insert(text);
        }
        EXPECT_EQ(texts.size(), 32U);
    }
}

/// Around the mouth as the American Dental Association counts: upper right, upper left, lower left, lower right.
TEST(ToothNotation, UniversalNumbersGoAroundTheMouth) {
    int number = 0;
    for (int place = 8; place >= 1; --place)
        EXPECT_EQ(toothNamed(std::to_string(++number), ToothNotation::Universal), 10 + place);
    for (int place = 1; place <= 8; ++place)
        EXPECT_EQ(toothNamed(std::to_string(++number), ToothNotation::Universal), 20 + place);
    for (int place = 8; place >= 1; --place)
        EXPECT_EQ(toothNamed(std::to_string(++number), ToothNotation::Universal), 30 + place);
    for (int place = 1; place <= 8; ++place)
        EXPECT_EQ(toothNamed(std::to_string(++number), ToothNotation::Universal), 40 + place);
    EXPECT_EQ(number, 32);
}

TEST(ToothNotation, ThePalmerCornerIsThatOfTheQuadrantOnThePatient) {
    EXPECT_EQ(toothLabel(16, ToothNotation::Palmer), "6┘");
    EXPECT_EQ(toothLabel(26, ToothNotation::Palmer), "└6");
    EXPECT_EQ(toothLabel(36, ToothNotation::Palmer), "┌6");
    EXPECT_EQ(toothLabel(46, ToothNotation::Palmer), "6┐");
    EXPECT_EQ(toothNamed("UR6", ToothNotation::Palmer), 16);
    EXPECT_EQ(toothNamed("UL1", ToothNotation::Palmer), 21);
    EXPECT_EQ(toothNamed("LL8", ToothNotation::Palmer), 38);
    EXPECT_EQ(toothNamed("LR4", ToothNotation::Palmer), 44);
}

TEST(ToothNotation, OtherTextsNameNoTooth) {
    for (const char* text : {"", "0", "19", "40", "49", "51", "046", "46 ", "+46", "-1", "UR6", "6┘"}) {
        EXPECT_FALSE(toothNamed(text, ToothNotation::Fdi)) << text;
    }
    for (const char* text : {"", "0", "33", "48", "01", "1a"}) {
        EXPECT_FALSE(toothNamed(text, ToothNotation::Universal)) << text;
    }
    for (const char* text : {"", "6", "UR", "UR0", "UR9", "UR16", "┘6", "6└", "ur6", "XX1", "┘", "46"}) {
        EXPECT_FALSE(toothNamed(text, ToothNotation::Palmer)) << text;
    }
}

TEST(ToothNotation, TheTitleIsTheNameOfTheTooth) {
    for (const int fdi : permanentTeeth()) EXPECT_EQ(toothTitle(fdi).in(Language::English), toothName(fdi));
    EXPECT_EQ(toothTitle(46).in(Language::Japanese), "下顎右側第一大臼歯");
    EXPECT_EQ(toothTitle(21).in(Language::Japanese), "上顎左側中切歯");
}

}  // namespace
}  // namespace tactooth
