// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/number_text.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

TEST(NumberText, ReadsWhatProgramsWrite) {
    EXPECT_EQ(toNumber<double>("0.1"), 0.1);
    EXPECT_EQ(toNumber<double>("+1.5E+02"), 150.0);
    EXPECT_EQ(toNumber<double>("-.5"), -0.5);
    EXPECT_EQ(toNumber<double>("7."), 7.0);
    EXPECT_EQ(toNumber<float>("0.1"), 0.1F);
}

TEST(NumberText, RefusesWhatIsNotANumberAsAWhole) {
    for (const char* word : {"", "+", "-", ".", "e5", "1,5", "1.5mm", "+-1", "++1", "0x10", " 1", "1 "}) {
        EXPECT_EQ(toNumber<double>(word), std::nullopt) << word;
    }
}

TEST(NumberText, TooSmallIsZeroAndTooLargeIsInfinite) {
    EXPECT_EQ(toNumber<float>("1e-60"), 0.0F);
    EXPECT_EQ(toNumber<double>("-1E-999"), 0.0);
    EXPECT_EQ(toNumber<float>("1e39"), std::numeric_limits<float>::infinity());
    EXPECT_EQ(toNumber<double>("1e999"), std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(toNumber<double>("nan").value()));
}

TEST(NumberText, QuotedWordsAreShortAndPrintable) {
    EXPECT_EQ(quotedWord("1,5"), "'1,5'");
    EXPECT_EQ(quotedWord("a\x1b\n"),
              "'a?"
              "?'");
    EXPECT_EQ(quotedWord(std::string(100, 'x')), "'" + std::string(24, 'x') + "...'");
}

}  // namespace
}  // namespace tactooth
