// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <array>
#include <utility>

#include "assessment/messages.h"
#include "assessment/report/assessment_report.h"

namespace tactooth {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

/// A report whose criteria all have lost something; the tooth is seen from the occlusal side.
class ErrorTexts : public testing::Test {
protected:
    void add(std::string_view metric, Measured measured, bool limits = false) {
        const PreparationMetric* const row = findPreparationMetric(metric);
        rubric_.criteria.push_back({.title = std::string(row->title),
                                    .metric = row,
                                    .weight = limits ? 0.0 : 10.0,
                                    .levels = LevelRanges(kRanges),
                                    .limitsMark = limits});
        results_.push_back({row, std::move(measured)});
    }
    std::vector<ErrorText> texts(Language language = Language::English) {
        report_.rubric = &rubric_;
        report_.mark = markOf(rubric_, results_);
        return errorTexts(report_, language);
    }
    static Measured measured(double value, const Vec3& place, const RemovalCause& cause) {
        return {.value = value, .place = place, .moment = cause.to, .cause = cause};
    }

    static constexpr std::array<LevelRanges::Range, 4> kRanges = {{{0, 0}, {0, 0.1}, {0, 0.2}, {0, 0.3}}};
    static constexpr RemovalCause kCause = {134.2, 138.6, 1.84, 14.2};
    const Vec3 corner_ = Vec3(-2, 2, 3);  // mesial is +x
    Rubric rubric_ = {.name = "Test", .criteria = {}};
    std::vector<MetricResult> results_;
    AssessmentReport report_{.student = "lee.ttsession", .expert = "b"};
};

TEST_F(ErrorTexts, NameWallAmountPlaceMomentForceAndTilt) {
    report_.errors = {{&msg::kWallBuccal, 0.42, 0.8, corner_, 138.0, kCause}};
    add("over_max", measured(0.42, corner_, kCause));
    ASSERT_THAT(texts(), SizeIs(1));
    EXPECT_EQ(texts()[0].text,
              "Buccal wall 0.42 mm over-prepared (distobuccal) between 2:14 and 2:19; force 1.8 N, bur tilted 14 "
              "degrees.");
    EXPECT_EQ(texts(Language::Japanese)[0].text,
              "頬側壁：0.42 mm の削りすぎ（遠心頬側）。2:14 から 2:19 の間、力 1.8 N、バーの傾き 14 度。");
    EXPECT_EQ(texts()[0].command, "tactooth replay 'lee.ttsession' --until 139 --out moment");
}

TEST_F(ErrorTexts, LeaveOutWhatIsNotKnown) {
    report_.errors = {{&msg::kWallFloor, 0.42, 0.8, corner_, {}, {}}};
    add("over_max", Measured::at(0.42, corner_));
    EXPECT_EQ(texts()[0].text, "Floor 0.42 mm over-prepared (distobuccal).");
    EXPECT_EQ(texts()[0].command, "");
    report_.errors = {{&msg::kWallFloor, 0.42, 0.8, corner_, 138.0, RemovalCause{134.2, 138.6, 1.84}}};
    EXPECT_EQ(texts()[0].text, "Floor 0.42 mm over-prepared (distobuccal) between 2:14 and 2:19; force 1.8 N.");
    report_.student = "l'ee.ttsession";
    EXPECT_EQ(texts()[0].command, "") << "a shell would change it";
    report_.student = "lee.tactooth";
    EXPECT_EQ(texts()[0].command, "") << "there is nothing to replay";
}

TEST_F(ErrorTexts, SayEachOverPreparationOnceAndThenOtherErrors) {
    const Vec3 other(2, 0, 3);
    report_.errors = {{&msg::kWallBuccal, 0.42, 0.8, corner_, 138.0, kCause},
                      {&msg::kWallMesial, 0.35, 0.2, other, 20.0, RemovalCause{18, 20, 0.5, 3.0}}};
    add("over_max", measured(0.42, corner_, kCause));
    add("over_volume", measured(0.9, corner_, kCause));
    add("ridge_min_m", measured(0.8, Vec3(3, 0, 3), RemovalCause{18, 20, 0.5, 3.0}));
    const auto all = texts();
    ASSERT_THAT(all, SizeIs(3));
    EXPECT_THAT(all[1].text, HasSubstr("Mesial wall 0.35 mm over-prepared (mesial) between 0:18 and 0:20"));
    EXPECT_THAT(all[2].text, HasSubstr("Mesial ridge left: 0.80 mm, mesial, cut between 0:18 and 0:20"));
}

TEST_F(ErrorTexts, NameAnErrorThatOnlyLimitsTheMark) {
    add("cleared_share", Measured::of(0));
    add("pulp_open", measured(1, corner_, kCause), true);
    const auto all = texts();
    ASSERT_THAT(all, SizeIs(1));
    EXPECT_THAT(all[0].text, HasSubstr("Pulp opened: 1, distobuccal, cut between 2:14 and 2:19"));
}

TEST_F(ErrorTexts, AreNoneWhereNothingWasLost) {
    report_.errors = {{&msg::kWallBuccal, 0.02, 0.01, corner_, 138.0, kCause}};
    add("over_max", measured(0, corner_, kCause));
    EXPECT_THAT(texts(), SizeIs(0));
}

}  // namespace
}  // namespace tactooth
