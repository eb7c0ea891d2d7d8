// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/next_steps.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "assessment/rubric/rubric_file.h"

namespace tactooth {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// A report by a rubric with the usual ranges around `ideal`.
class NextSteps : public testing::Test {
protected:
    void add(std::string_view metric, double value, std::array<LevelRanges::Range, 4> ranges, bool limits = false) {
        rubric_.criteria.push_back({.title = std::string(findPreparationMetric(metric)->title),
                                    .metric = findPreparationMetric(metric),
                                    .weight = 10,
                                    .levels = LevelRanges(ranges),
                                    .limitsMark = limits});
        results_.push_back({findPreparationMetric(metric), Measured::of(value)});
    }
    std::vector<std::string> steps() {
        report_.rubric = &rubric_;
        report_.mark = markOf(rubric_, results_);
        return nextSteps(report_);
    }
    void addOver(double value) { add("over_max", value, {{{0, 0.1}, {0, 0.3}, {0, 0.5}, {0, 1}}}); }

    Rubric rubric_ = {.name = "Test", .criteria = {}};
    std::vector<MetricResult> results_;
    AssessmentReport report_{.student = "a", .expert = "b"};
};

TEST_F(NextSteps, PraisesWhatCostsNothing) {
    addOver(0.05);
    EXPECT_THAT(steps(), ElementsAre(StartsWith("Nothing costs a point")));
}

TEST_F(NextSteps, SayWhatCostsMostFirst) {
    addOver(0.4);
    add("floor_depth_median", 1.2, {{{1.5, 2}, {1.3, 2.1}, {1, 2.3}, {0.75, 2.5}}});
    add("isthmus_min", 2.4, {{{1, 1.5}, {0.9, 1.7}, {0.7, 2}, {0.5, 2.5}}});
    EXPECT_THAT(steps(), ElementsAre(HasSubstr("Keep the isthmus narrower: it is 2.40 mm"),
                                     HasSubstr("you went 0.40 mm beyond the ideal wall")));
}

TEST_F(NextSteps, SayWhetherAValueIsTooLowOrTooHigh) {
    add("floor_depth_median", 1.2, {{{1.5, 2}, {1.3, 2.1}, {1, 2.3}, {0.75, 2.5}}});
    EXPECT_THAT(steps(), ElementsAre("Cut the floor deeper: it lies at 1.20 mm."));
    results_[0].measured.value = 2.4;
    EXPECT_THAT(steps(), ElementsAre("Keep the floor shallower: it lies at 2.40 mm."));
}

TEST_F(NextSteps, BeginWithWhatLimitsTheMark) {
    addOver(0.4);
    add("cleared_share", 0.5, {{{0.9, 1}, {0.8, 1}, {0.7, 1}, {0.1, 1}}}, true);
    EXPECT_THAT(steps().front(), StartsWith("Clear the whole marked part"));
}

TEST_F(NextSteps, NameThePlaceAndTheMoment) {
    addOver(0.4);
    results_[0].measured = Measured::at(0.4, Vec3(0, 2, 0));
    results_[0].measured.moment = 134;
    EXPECT_THAT(steps(), ElementsAre(HasSubstr("0.40 mm (buccal, 2:14)")));
}

TEST_F(NextSteps, SpeakJapanese) {
    addOver(0.4);
    results_[0].measured = Measured::at(0.4, Vec3(0, 2, 0));
    results_[0].measured.moment = 134;
    report_.language = Language::Japanese;
    EXPECT_THAT(steps(), ElementsAre(HasSubstr("理想の壁を 0.40 mm（頬側、2:14） 越えました。")));
}

/// Each criterion of each built-in rubric has advice of its own, on the side on which it can be off.
TEST(NextStepsOfRubrics, HaveWordsForEachCriterion) {
    for (const char* name :
         {"near-ideal", "near-ideal-strict", "class-1", "class-1-conservative", "class-2", "class-3", "class-3-lingual",
          "class-5", "class-5-conservative", "fissurotomy", "endodontic-access"}) {
        const auto rubric = findRubric(name);
        ASSERT_TRUE(rubric) << rubric.error().message();
        for (const Criterion& criterion : rubric->criteria) {
            for (const bool low : {true, false}) {
                if (low ? !criterion.levels.hasLowerLimit() : !criterion.levels.hasUpperLimit()) continue;
                const LevelRanges::Range& zero = criterion.levels.ranges()[3];
                Rubric one{.name = "One", .criteria = {criterion}};
                one.criteria[0].weight = 10;
                AssessmentReport report{.student = "a", .expert = "b", .rubric = &one};
                report.mark = markOf(one, {{criterion.metric, Measured::of(low ? zero.low : zero.high)}});
                EXPECT_THAT(nextSteps(report).front(), testing::Not(StartsWith("Work on this")))
                    << name << ", " << criterion.metric->id << (low ? " low" : " high");
                const std::string japanese = nextSteps(report, Language::Japanese).front();
                EXPECT_THAT(japanese, testing::AllOf(testing::EndsWith("。"), testing::Not(StartsWith("「"))));
            }
        }
    }
}

}  // namespace
}  // namespace tactooth
