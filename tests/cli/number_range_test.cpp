// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/terminal/number_range.h"

#include <cmath>
#include <limits>
#include <random>

#include "cli/cli_test.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

using namespace test;

/// The validator's message; empty if it accepts the text.
std::string said(const CLI::Validator& validator, std::string text) { return validator(text); }

TEST(NumberRange, TakesNumbersInTheRangeWithItsEnds) {
    const CLI::Validator spacing = numberFrom(0.005, 0.5);
    for (const char* text : {"0.005", "0.5", ".1", "+0.25", "2.5e-2", "00.1", "0.5000"}) {
        EXPECT_EQ(said(spacing, text), "") << text;
    }
    const CLI::Validator count = wholeNumberFrom(-3, 2'000'000);
    for (const char* text : {"-3", "0", "7", "2000000", "007", "+5"}) EXPECT_EQ(said(count, text), "") << text;
}

TEST(NumberRange, RefusesWhatIsNotFiniteInShortNumbers) {
    EXPECT_EQ(said(numberFrom(0.005, 1), "nan"), "must be a number from 0.005 to 1, but is nan");
    EXPECT_EQ(said(numberFrom(0, 1e6), "inf"), "must be a number from 0 to 1000000, but is inf");
    for (const char* text : {"nan", "NaN", "-nan", "nan(1)", "inf", "-inf", "+inf", "infinity", "1e999", "-1e999"}) {
        EXPECT_THAT(said(numberFrom(-1e300, 1e300), text), StartsWith("must be a number from ")) << text;
        EXPECT_THAT(said(wholeNumberFrom(0, 10), text), StartsWith("must be a whole number from 0 to 10, but is "));
    }
}

TEST(NumberRange, RefusesWhatIsNoNumberAsAWhole) {
    for (const char* text :
         {"", " ", "1 ", " 1", "1,5", "1.5mm", "0x10", "0b1", "1_000", "one", "--1", "1e", "\xC2\xBD"}) {
        EXPECT_THAT(said(numberFrom(-100, 100), text), StartsWith("must be a number from -100 to 100, but is "))
            << text;
        EXPECT_THAT(said(wholeNumberFrom(-100, 100), text), StartsWith("must be a whole number from ")) << text;
    }
    for (const char* text :
         {"99999999999999999999", "1e3", "10.0", "9223372036854775808", "-9223372036854775809", "+-5"}) {
        EXPECT_THAT(said(wholeNumberFrom(0, 100), text), StartsWith("must be a whole number from ")) << text;
    }
    EXPECT_EQ(said(wholeNumberFrom(1, 9), "1e3"), "must be a whole number from 1 to 9, but is 1e3");
    EXPECT_EQ(said(wholeNumberFrom(1, 9), "x\x1b[2J"), "must be a whole number from 1 to 9, but is 'x?[2J'");
}

TEST(NumberRange, WhatIsTakenReachesTheOptionAsTheSameNumber) {
    std::mt19937_64 random(20261125);
    for (int round = 0; round < 2000; ++round) {
        CLI::App app;
        double number = 0;
        std::int64_t whole = 0;
        app.add_option("--number", number)->transform(numberFrom(-1e9, 1e9));
        app.add_option("--whole", whole)->transform(wholeNumberFrom(-1'000'000, 1'000'000));
        const double wantedNumber = std::ldexp(static_cast<double>(random()), -40 - static_cast<int>(random() % 40));
        const auto wantedWhole = static_cast<std::int64_t>(random() % 2'000'001) - 1'000'000;
        std::string text = std::to_string(std::abs(wantedWhole));
        text = (wantedWhole < 0 ? "-" : "") + std::string(random() % 4, '0') + text;  // zeros do not make it octal
        app.parse("--number=" + numberText(wantedNumber) + " --whole=" + text);
        ASSERT_EQ(number, wantedNumber);
        ASSERT_EQ(whole, wantedWhole) << text;
    }
}

TEST(NumberRange, TheProgramSaysItInOneSentence) {
    const ProgramRun run = runTactooth({"demo", "--seconds", "nan", "--out", "x"});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_EQ(run.err, "tactooth: --seconds must be a number from 1 to 600, but is nan; see 'tactooth demo --help'.\n");
}

}  // namespace
}  // namespace tactooth
