// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/track/replay_comments.h"

#include <gmock/gmock.h>

#include <fstream>

#include "support/test_data.h"

namespace tactooth {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ReplayCommentsTest : public ::testing::Test {
protected:
    ReplayComments opened() const {
        auto comments = ReplayComments::open(recording_);
        EXPECT_TRUE(comments) << comments.error().message();
        return *comments;
    }
    std::string refusalOf(const std::string& content) const {
        std::ofstream(recording_.string() + ".comments.json") << content;
        const auto comments = ReplayComments::open(recording_);
        EXPECT_FALSE(comments) << content;
        return comments ? std::string() : comments.error().message();
    }

    test::TemporaryFolder folder_;
    std::filesystem::path recording_ = folder_ / "s.ttsession";
};

TEST_F(ReplayCommentsTest, AreKeptBesideTheRecordingByTheirTime) {
    EXPECT_THAT(opened().all(), IsEmpty());
    EXPECT_FALSE(std::filesystem::exists(recording_.string() + ".comments.json"));
    ReplayComments comments = opened();
    ASSERT_TRUE(comments.add({12.5, "too deep \"here\""}));
    ASSERT_TRUE(comments.add({3, "歯髄が近い"}));
    ASSERT_TRUE(comments.add({3, "second at the same time"}));
    const ReplayComment deep{12.5, "too deep \"here\""}, near{3, "歯髄が近い"}, second{3, "second at the same time"};
    EXPECT_THAT(opened().all(), ElementsAre(near, second, deep));
    ASSERT_TRUE(comments.remove(0));
    EXPECT_THAT(opened().all(), ElementsAre(second, deep));
    EXPECT_FALSE(std::filesystem::exists(recording_));  // never touched
}

TEST_F(ReplayCommentsTest, ALongTextIsShortenedBetweenCharacters) {
    ReplayComments comments = opened();
    std::string text(ReplayComments::kMostBytes - 1, 'x');
    ASSERT_TRUE(comments.add({1, text + "歯"}));
    EXPECT_EQ(opened().all().front().text, text);
}

TEST_F(ReplayCommentsTest, ADamagedFileHasASentenceAndIsNotOverwritten) {
    EXPECT_THAT(refusalOf("no JSON"), HasSubstr("s.ttsession.comments.json"));
    (void)refusalOf("");
    (void)refusalOf("[]");
    (void)refusalOf("{\"comments\": 3}");
    EXPECT_THAT(refusalOf("{\"comments\": [{\"time_s\": 1, \"text\": \"a\"}, {\"time_s\": -1, \"text\": \"b\"}]}"),
                HasSubstr("comment 2"));
    (void)refusalOf("{\"comments\": [{\"time_s\": \"1\", \"text\": \"a\"}]}");
    (void)refusalOf("{\"comments\": [{\"time_s\": 1e300, \"text\": \"a\"}]}");
    (void)refusalOf("{\"comments\": [{\"time_s\": 1}]}");
    (void)refusalOf("{\"comments\": [7]}");
    (void)refusalOf(std::string(100'000, '['));
}

TEST_F(ReplayCommentsTest, WhereNothingCanBeWrittenTheCommentsStayAsTheyWere) {
    auto comments = ReplayComments::open(folder_ / "missing" / "s.ttsession");
    ASSERT_TRUE(comments);
    const auto added = comments->add({1, "lost"});
    ASSERT_FALSE(added);
    EXPECT_THAT(added.error().message(), HasSubstr("missing"));
    EXPECT_THAT(comments->all(), IsEmpty());
}

}  // namespace
}  // namespace tactooth
