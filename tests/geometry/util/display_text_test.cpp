// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/display_text.h"

#include <gtest/gtest.h>

#include <random>

namespace tactooth {
namespace {

constexpr const char* kReplacement = "\xEF\xBF\xBD";

TEST(DisplayText, KeepsWhatPeopleWrite) {
    for (const char* text :
         {"", "36.stl", "Z\xC3\xA4hne", "\xE6\xAD\xAF.stl", "\xF0\x9F\xA6\xB7", "a'b\"c\\d", "\xC2\xA0"}) {
        EXPECT_EQ(displayText(text), text);
        EXPECT_TRUE(isShownAsItIs(text)) << text;
    }
}

TEST(DisplayText, ControlCharactersBecomeQuestionMarks) {
    EXPECT_EQ(displayText("a\x1b[2Jb"), "a?[2Jb");
    EXPECT_EQ(displayText("a\r\n\tb"), "a?\?\?b");
    EXPECT_EQ(displayText(std::string_view("a\0b", 3)), "a?b");
    EXPECT_EQ(displayText("a\x7f"), "a?");
    EXPECT_EQ(displayText("a\xC2\x9B"
                          "31m"),
              "a?31m");  // CSI of C1
    EXPECT_EQ(displayText("a\xC2\x85"
                          "b"),
              "a?b");  // next line
}

TEST(DisplayText, MarksOfDirectionBecomeQuestionMarks) {
    for (const char* mark : {"\xE2\x80\xAA", "\xE2\x80\xAB", "\xE2\x80\xAC", "\xE2\x80\xAD", "\xE2\x80\xAE",
                             "\xE2\x81\xA6", "\xE2\x81\xA7", "\xE2\x81\xA8", "\xE2\x81\xA9", "\xE2\x80\x8E",
                             "\xE2\x80\x8F", "\xD8\x9C", "\xE2\x80\xA8", "\xE2\x80\xA9"}) {
        EXPECT_EQ(displayText(std::string("lts.") + mark + "exe"), "lts.?exe");
        EXPECT_FALSE(isShownAsItIs(mark));
    }
}

TEST(DisplayText, BytesThatAreNoUtf8AreReplacedOneByOne) {
    for (const char* text : {"\xff", "\x80", "\xC0", "\xE4", "\xC3", "\xF5"}) {
        EXPECT_EQ(displayText(std::string("a") + text + "b"), std::string("a") + kReplacement + "b") << text;
    }
    EXPECT_EQ(displayText("\xC0\x9B"), std::string(kReplacement) + kReplacement);                     // overlong
    EXPECT_EQ(displayText("\xED\xA0\x80"), std::string(kReplacement) + kReplacement + kReplacement);  // surrogate
    EXPECT_EQ(displayText("\xE2\x80"), std::string(kReplacement) + kReplacement);                     // cut short
}

TEST(DisplayText, ShortensBetweenCharacters) {
    EXPECT_EQ(displayShort("\xC3\xA4\xC3\xB6\xC3\xBC", 2), "\xC3\xA4\xC3\xB6...");
    EXPECT_EQ(displayShort("ab", 2), "ab");
}

TEST(DisplayText, AnyBytesBecomeOneLineThatStaysAsItIs) {
    std::mt19937 random(20261125);
    for (int round = 0; round < 20000; ++round) {
        std::string bytes(random() % 12, '\0');
        for (char& byte : bytes) byte = static_cast<char>(random() % 3 == 0 ? 0xC0 + random() % 64 : random());
        const std::string shown = displayText(bytes);
        ASSERT_TRUE(isShownAsItIs(shown));
        ASSERT_EQ(displayText(shown), shown);
        ASSERT_EQ(isShownAsItIs(bytes), shown == bytes);
    }
}

}  // namespace
}  // namespace tactooth
