// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/unicode_text.h"

#include <gtest/gtest.h>

#include <random>

namespace tactooth {
namespace {

TEST(ValidUtf8, KeepsWhatIsValid) {
    for (const char* const text : {"", "36", "Z\xC3\xA4hne", "\xE6\xAD\xAF", "\xF0\x9F\xA6\xB7", "a\xCC\x88"})
        EXPECT_EQ(validUtf8(text), text);
}

TEST(ValidUtf8, EachByteThatIsNoneBecomesOneSign) {
    EXPECT_EQ(validUtf8("Z\xE4hne"), "Z\xEF\xBF\xBDhne");                      // Latin-1
    EXPECT_EQ(validUtf8("\x8E\x95"), "\xEF\xBF\xBD\xEF\xBF\xBD");              // Shift-JIS
    EXPECT_EQ(validUtf8("\xC3"), "\xEF\xBF\xBD");                              // cut off
    EXPECT_EQ(validUtf8("\xED\xA0\x80").find("\xED\xA0"), std::string::npos);  // half of a pair
    EXPECT_EQ(validUtf8("\xC0\xAF").find('\xC0'), std::string::npos);          // longer than it must be
}

TEST(ValidUtf8, ItsResultIsValidWhateverTheBytes) {
    std::mt19937 random(20261125);
    for (int round = 0; round < 2000; ++round) {
        std::string bytes;
        for (unsigned i = random() % 20; i-- > 0;) bytes += static_cast<char>(random());
        const std::string valid = validUtf8(bytes);
        EXPECT_EQ(validUtf8(valid), valid);
        EXPECT_EQ(composed(composed(bytes)), composed(bytes));
    }
}

TEST(Composed, LettersAndTheirMarksBecomeOne) {
    EXPECT_EQ(composed("a\xCC\x88"), "\xC3\xA4");                        // ä
    EXPECT_EQ(composed("\xC3\xA4"), "\xC3\xA4");                         //
    EXPECT_EQ(composed("e\xCC\x81t\x65\xCC\x81"), "\xC3\xA9t\xC3\xA9");  // été
    EXPECT_EQ(composed("\xE3\x81\xAF\xE3\x82\x99"), "\xE3\x81\xB0");     // ば
    EXPECT_EQ(composed("\xE1\x84\x8B\xE1\x85\xB5"), "\xEC\x9D\xB4");     // 이
    EXPECT_EQ(composed("plain"), "plain");
}

TEST(Composed, WhatIsNoUtf8Stays) { EXPECT_EQ(composed("Z\xE4hne a\xCC\x88"), "Z\xE4hne a\xCC\x88"); }

}  // namespace
}  // namespace tactooth
