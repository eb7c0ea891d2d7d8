// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/message.h"

#include <gtest/gtest.h>

#include <string>

#include "geometry/util/expected.h"

namespace tactooth {
namespace {

constexpr MessageText kPlain{"plain", "It is closed.", "閉じています。"};
constexpr MessageText kTwo{"two", "%2 before %1, 5% of it", "%1の前に%2、5%"};
constexpr MessageText kPart{"part", "the layer '%1'", "層「%1」"};
constexpr MessageText kOuter{"outer", "%1: %2.", "%1：%2。"};
constexpr MessageText kInner{"inner", "%1 is open: close it.", "%1が開いています。閉じてください。"};

TEST(Message, IsItsRowInEitherLanguage) {
    const Message message(kPlain);
    EXPECT_EQ(message.in(Language::English), "It is closed.");
    EXPECT_EQ(message.in(Language::Japanese), "閉じています。");
    EXPECT_EQ(message.id(), "plain");
}

TEST(Message, ArgumentsStandInTheirPlaces) {
    const Message message(kTwo, "a", std::string("b"));
    EXPECT_EQ(message.in(Language::English), "b before a, 5% of it");
    EXPECT_EQ(message.in(Language::Japanese), "aの前にb、5%");
}

TEST(Message, WholeNumbersAreWrittenOut) {
    EXPECT_EQ(Message(kTwo, std::size_t{18446744073709551615U}, -7).in(Language::English),
              "-7 before 18446744073709551615, 5% of it");
}

TEST(Message, PlacesWithinAnArgumentStayAsTheyAre) {
    EXPECT_EQ(Message(kTwo, "%2", "%1%%").in(Language::English), "%1%% before %2, 5% of it");
}

TEST(Message, MessagesWithinMessagesTakeTheLanguage) {
    const Message message(kOuter, "a.stl", Message(kPart, "pulp"));
    EXPECT_EQ(message.in(Language::English), "a.stl: the layer 'pulp'.");
    EXPECT_EQ(message.in(Language::Japanese), "a.stl：層「pulp」。");
}

TEST(Message, ASentenceAtTheEndOfAnotherEndsOnce) {
    const Message message(kOuter, "a.stl", Message(kInner, Message(kPart, "pulp")));
    EXPECT_EQ(message.in(Language::English), "a.stl: the layer 'pulp' is open: close it.");
    EXPECT_EQ(message.in(Language::Japanese), "a.stl：層「pulp」が開いています。閉じてください。");
}

TEST(Message, ANameThatEndsInAStopKeepsIt) { EXPECT_EQ(Message(kOuter, "a", "b.").in(Language::English), "a: b.."); }

TEST(Message, VerbatimWordsAreTheSameInEveryLanguage) {
    const Message message = Message::verbatim("libHD.so: %1");
    EXPECT_EQ(message.in(Language::English), "libHD.so: %1");
    EXPECT_EQ(message.in(Language::Japanese), "libHD.so: %1");
    EXPECT_EQ(message.id(), "");
}

TEST(Message, WordsOfADataFileFollowTheLanguage) {
    const Message message = Message::bilingual("gold", "金");
    EXPECT_EQ(message.in(Language::English), "gold");
    EXPECT_EQ(message.in(Language::Japanese), "金");
    EXPECT_EQ(Message::bilingual("gold", "").in(Language::Japanese), "gold");
}

TEST(Message, KnowsTheRowsThatItContains) {
    const Message message(kOuter, "a", Message(kInner, kPlain));
    EXPECT_TRUE(message.contains(kOuter));
    EXPECT_TRUE(message.contains(kInner));
    EXPECT_TRUE(message.contains(kPlain));
    EXPECT_FALSE(message.contains(kPart));
}

TEST(Message, TheFirstArgumentCanBeReplaced) {
    Message message(kOuter, "/home/somebody/a.stl", kPlain);
    message.replaceFirst("a.stl");
    EXPECT_EQ(message.in(Language::English), "a.stl: It is closed.");
}

TEST(Message, IsEmptyUntilItSaysSomething) {
    EXPECT_TRUE(Message().empty());
    EXPECT_FALSE(Message(kPlain).empty());
    EXPECT_EQ(Message().in(Language::Japanese), "");
}

TEST(Error, IsAMessageOnItsWayOut) {
    const Expected<int> failed = unexpected(kInner, kPlain);
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().id(), "inner");
    EXPECT_EQ(failed.error().message(), "It is closed. is open: close it.");
    const Expected<int> named = unexpected(kOuter, "a", failed.error());
    EXPECT_TRUE(named.error().contains(kInner));
}

}  // namespace
}  // namespace tactooth
