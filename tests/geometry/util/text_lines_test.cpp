// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/text_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tactooth {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> all;
    TextLines lines(text);
    for (std::string_view line; lines.next(line);) {
        all.emplace_back(line);
        EXPECT_EQ(lines.number(), all.size());
    }
    return all;
}

TEST(TextLines, EndInAnyOfTheThreeWays) {
    EXPECT_THAT(linesOf("a\nb\nc"), ElementsAre("a", "b", "c"));
    EXPECT_THAT(linesOf("a\r\nb\r\nc\r\n"), ElementsAre("a", "b", "c"));
    EXPECT_THAT(linesOf("a\rb\rc\r"), ElementsAre("a", "b", "c"));
    EXPECT_THAT(linesOf("a\rb\nc\r\nd"), ElementsAre("a", "b", "c", "d"));
    EXPECT_THAT(linesOf("a\n\rb"), ElementsAre("a", "", "b"));
}

TEST(TextLines, EmptyLinesCount) {
    EXPECT_THAT(linesOf(""), ElementsAre());
    EXPECT_THAT(linesOf("\n\n"), ElementsAre("", ""));
    EXPECT_THAT(linesOf("\r\r\n\r"), ElementsAre("", "", ""));
}

TEST(TextLines, AByteOrderMarkIsNoPartOfTheFirst) {
    EXPECT_THAT(linesOf("\xEF\xBB\xBFv 1\nv \xEF\xBB\xBF"), ElementsAre("v 1", "v \xEF\xBB\xBF"));
    EXPECT_THAT(linesOf("\xEF\xBB\xBF"), ElementsAre());
}

}  // namespace
}  // namespace tactooth
