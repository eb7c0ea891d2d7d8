// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/limited_toml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string repeated(const std::string& text, std::size_t times) {
    std::string result;
    for (std::size_t i = 0; i < times; ++i) result += text;
    return result;
}

std::string refusal(const std::string& text) {
    const auto table = parseToml(text, "a.toml");
    return table ? "accepted" : table.error().message();
}

/// Nesting depth of tables and lists, computed without recursion.
std::size_t depthOf(const toml::table& root) {
    std::vector<std::pair<const toml::node*, std::size_t>> open = {{&root, 1}};
    std::size_t deepest = 0;
    while (!open.empty()) {
        const auto [node, depth] = open.back();
        open.pop_back();
        deepest = std::max(deepest, depth);
        if (const auto* table = node->as_table()) {
            for (auto&& [key, value] : *table) open.emplace_back(&value, depth + 1);
        } else if (const auto* list = node->as_array()) {
            for (const toml::node& value : *list) open.emplace_back(&value, depth + 1);
        }
    }
    return deepest;
}

TEST(LimitedToml, TakesWhatPeopleWrite) {
    const std::string dots(40, '.'), brackets(60, '[');
    for (const std::string& text :
         {std::string(), std::string("a = 1"), "[a.b.c]\nd = 1.5 # " + dots + "\n", "t = \"" + dots + "\"",
          "t = '" + dots + "'", "t = \"\"\"\n" + dots + "\n\"\"\"", "t = '''\n" + brackets + "\n'''",
          "t = \"a\\\"" + dots + "\"", "t = \"\"\"a\\\"\"\"" + dots + "\"\"\"", std::string("a.\"b.c.d\".'e.f' = 2"),
          std::string("a = [[1.5, 2.5], [3.5]]\n[[b]]\nc = {d = {e = 1}}\n")}) {
        EXPECT_EQ(refusal(text), "accepted") << text;
    }
    EXPECT_EQ(refusal("a = [" + repeated("1.25, ", 5000) + "]"), "accepted");
}

TEST(LimitedToml, KeysWithManyDotsAreRefused) {
    for (const std::size_t dots : {16U, 17U, 1000U, 15'000U}) {
        const std::string key = "a" + repeated(".a", dots);
        for (const std::string& text : {key + " = 1", "[" + key + "]\n", "[[" + key + "]]\n", "x = {" + key + " = 1}",
                                        "x = [{" + key + " = 1}]", "x = {a = 1, " + key + " = 1}",
                                        "a" + repeated(" . a", dots) + " = 1", "a" + repeated(".'a'", dots) + " = 1"}) {
            EXPECT_THAT(refusal("# comment\n" + text), HasSubstr("line 2: a key has more than 16 parts")) << dots;
        }
    }
    EXPECT_EQ(refusal("a" + repeated(".a", 16) + " = 1"),
              "a.toml, line 1: a key has more than 16 parts with dots between them; write a shorter one.");
    EXPECT_EQ(refusal("a" + repeated(".a", 15) + " = 1"), "accepted");
    EXPECT_THAT(refusal("a" + repeated(".a", 100'000) + " = 1"), StartsWith("a.toml, line 1: the line is longer than"));
    EXPECT_THAT(refusal("a" + repeated(".\na", 100'000) + " = 1"), StartsWith("a.toml, line 1: "));
}

TEST(LimitedToml, BracketsThatStandDeepAreRefused) {
    for (const std::size_t depth : {33U, 200U, 300U, 5000U, 60'000U, 900'000U}) {
        for (const std::string& text : {"a = " + repeated("[", depth), "a = " + repeated("[\n", depth),
                                        "a = " + repeated("{a=", depth), "a = " + repeated("[{a=", depth),
                                        repeated("[", depth), "a = " + repeated("[", depth) + repeated("]", depth)}) {
            EXPECT_THAT(refusal(text), StartsWith("a.toml")) << depth;
        }
    }
    EXPECT_EQ(refusal("a = " + repeated("[", 32) + repeated("]", 32)), "accepted");
    EXPECT_EQ(refusal("a = " + repeated("[", 33) + repeated("]", 33)),
              "a.toml, line 1: brackets stand more than 32 deep in each other; write it flatter.");
}

TEST(LimitedToml, SizeLineAndNumberOfValuesAreBounded) {
    EXPECT_EQ(refusal(std::string(kTomlLimits.bytes + 1, ' ')),
              "a.toml: the file is too large: a TOML file may have 1048576 bytes at most.");
    EXPECT_EQ(refusal("a = 1\nt = \"" + std::string(kTomlLimits.lineBytes, 'x') + "\"\n"),
              "a.toml, line 2: the line is longer than 65536 bytes; break it up.");
    EXPECT_THAT(refusal("a = [\n" + repeated("1,\n", 60'000) + "]"),
                HasSubstr(": there are more than 50000 values; keep to what is asked for."));
    EXPECT_THAT(refusal(repeated("[[a]]\n", 60'000)), HasSubstr("more than 50000 values"));
    std::string keys;
    for (int i = 0; i < 60'000; ++i) keys += "k" + std::to_string(i) + "=1\n";
    EXPECT_THAT(refusal(keys), HasSubstr("more than 50000 values"));
}

TEST(LimitedToml, WhatIsNoTomlIsOneSentenceWithTheLine) {
    for (const std::string text : {"a", "a =", "a = 1\nb = \"open\n", "[a\nb = 1", "a = 1e", "= 1", "a = 1\na = 2",
                                   "a = \x1b[31m", "# a\rb.b.b", "a = \"\xff\"", "a = 'b\xC2\x9B'\nc"}) {
        const std::string message = refusal(text);
        EXPECT_THAT(message, StartsWith("a.toml, line ")) << text;
        EXPECT_TRUE(message.ends_with('.')) << message;
        EXPECT_EQ(message.find_first_of("\n\x1b"), std::string::npos) << message;
        EXPECT_LT(message.size(), 400U);
    }
}

TEST(LimitedToml, ReadsAFileAndRefusesALargeOneUnread) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "a.toml", "a = 1\n");
    EXPECT_TRUE(readToml(folder / "a.toml"));
    std::filesystem::resize_file(folder / "a.toml", std::uintmax_t{1} << 33);
    const auto large = readToml(folder / "a.toml");
    ASSERT_FALSE(large);
    EXPECT_THAT(large.error().message(), HasSubstr("a.toml: the file holds 8589934592 bytes, and at most 1048576"));
}

// Limiter and parser must see the same strings and comments, or a deep key may hide in what the limiter takes for text.
TEST(LimitedToml, WhatIsTakenIsNeverDeep) {
    const std::string deep = "a" + repeated(".a", 17) + " = 1";
    const std::vector<std::string> pieces = {"\"",
                                             "'",
                                             "\"\"\"",
                                             "'''",
                                             "\\",
                                             "#",
                                             "\n",
                                             "\r",
                                             "\r\n",
                                             "[",
                                             "]",
                                             "{",
                                             "}",
                                             "=",
                                             ",",
                                             ".",
                                             " ",
                                             "a",
                                             "1",
                                             "\f",
                                             "\t",
                                             "a = 1\n",
                                             "[t]\n",
                                             "\xC2\x85",
                                             "\xE2\x80\xA8",
                                             "b = '",
                                             "c = \"\"\"\n",
                                             "d = '''",
                                             "k = [",
                                             "k = {",
                                             deep};
    std::mt19937 random(20261125);
    int taken = 0, hidden = 0;
    for (int round = 0; round < 100'000; ++round) {
        std::string text = random() % 2 == 0 ? "x = " : "";
        for (auto count = random() % 12; count > 0; --count) text += pieces[random() % pieces.size()];
        const auto table = parseToml(text, "a.toml");
        if (!table) continue;
        ++taken;
        if (text.find(deep) != std::string::npos) ++hidden;  // in a string or a comment
        ASSERT_LT(depthOf(*table), 18U) << text;
    }
    EXPECT_GT(taken, 500);
    EXPECT_GT(hidden, 10);
}

}  // namespace
}  // namespace tactooth
