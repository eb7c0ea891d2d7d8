// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/trial_trend.h"

#include <gmock/gmock.h>

#include "assessment/report/stored_report.h"
#include "assessment/report/trend_svg.h"

namespace tactooth {
namespace {

using testing::HasSubstr;
using testing::Not;

RecentMarks recentOf(const std::vector<double>& marks) { return recentMarks(marks); }

/// A fair coin shows six heads, or six tails, with a probability of 1 in 32: less than 5 %. With five it is 1 in 16.
TEST(RecentMarks, HaveAnIntervalFromSixTrialsOn) {
    EXPECT_FALSE(recentOf({70}).interval);
    EXPECT_FALSE(recentOf({70, 60, 80, 75, 65}).interval);
    EXPECT_EQ(recentOf({70, 60, 80, 75, 65, 90}).interval, (Interval{60, 90}));
    // Of nine, one or fewer heads have a probability of 10 / 512; of ten, 11 / 1024.
    EXPECT_EQ(recentOf({1, 2, 3, 4, 5, 6, 7, 8}).interval, (Interval{1, 8}));
    EXPECT_EQ(recentOf({9, 8, 7, 6, 5, 4, 3, 2, 1}).interval, (Interval{2, 8}));
    EXPECT_EQ(recentOf({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}).interval, (Interval{2, 9}));
}

TEST(RecentMarks, AreTheLastTen) {
    const RecentMarks recent = recentOf({0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
    EXPECT_EQ(recent.trials, 10U);
    EXPECT_EQ(recent.median, 5.5);
    EXPECT_EQ(recent.low, 1);
    EXPECT_EQ(recent.high, 10);
    EXPECT_EQ(recentOf({80, 60, 70}).median, 70);
}

/// A rubric of two criteria, and trials of which the second criterion costs more.
class TrialTrendDrawing : public testing::Test {
protected:
    TrialTrendDrawing() {
        for (const char* metric : {"over_max", "dice"}) {
            const PreparationMetric* found = findPreparationMetric(metric);
            rubric_.criteria.push_back({.title = std::string(found->title),
                                        .metric = found,
                                        .weight = 1,
                                        .levels = LevelRanges({{{0, 1}, {0, 2}, {0, 3}, {0, 4}}}),
                                        .japaneseTitle = std::string(found->titleJa)});
        }
        for (int i = 0; i < 7; ++i) trend_.trials.push_back({60.0 + 5 * i, i > 0, {{90, 5}, {30.0 + 10 * i, 20}}});
    }
    Rubric rubric_ = {.name = "Test", .criteria = {}};
    TrialTrend trend_;
};

TEST_F(TrialTrendDrawing, ShowsMarksIntervalAndWhatCostsMost) {
    const std::string svg = trendSvg(trend_, rubric_, 182, 36, Language::English);
    for (const char* words : {">Mark<", ">Overlap (Dice)<", "#2f7d4f", "#b23a24", "<rect", ">7<", "stroke-dasharray"})
        EXPECT_THAT(svg, HasSubstr(words));
    EXPECT_LT(svg.find("Overlap"), svg.find("Deepest")) << "the one that costs more comes first";
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(trendTexts(trend_, Language::English)[0],
                HasSubstr("last 7 trials: 75.0, with 95 % confidence between 60.0 and 90.0"));
    EXPECT_THAT(trendSvg(trend_, rubric_, 182, 36, Language::Japanese), HasSubstr("一致度（Dice"));
}

TEST_F(TrialTrendDrawing, HasNoBandForFewTrials) {
    trend_.trials.resize(2);
    EXPECT_THAT(trendSvg(trend_, rubric_, 182, 36, Language::English), Not(HasSubstr("<rect")));
    EXPECT_THAT(trendTexts(trend_, Language::English)[0], HasSubstr("too few trials for a confidence interval"));
    EXPECT_THAT(trendTexts(trend_, Language::Japanese)[0], HasSubstr("6 回必要"));
}

TEST_F(TrialTrendDrawing, LeavesOutACriterionThatCostsNothing) {
    for (TrialTrend::Trial& each : trend_.trials) each.scores[0] = {{}, 0};
    EXPECT_THAT(trendSvg(trend_, rubric_, 182, 36, Language::English), Not(HasSubstr("Deepest")));
}

std::string reportText(const std::string& from = {}, const std::string& to = {}) {
    std::string text =
        R"({"format": 1, "student": "a.stl", "name": "Ann", "date": "2026-11-27T10:00:00Z", "expert": "Class I",
        "rubric": {"name": "R", "pass": 65, "critical_mark": 40}, "mark": 71.5, "pass": true, "limited_by": ["dice"],
        "criteria": [{"metric": "dice", "weight": 0, "score": 71.5, "lost": 0, "ranges": {"ideal": [0.7, 1]}},
                     {"metric": "pulp_open", "weight": 5, "score": null, "lost": null}]})";
    if (!from.empty()) text.replace(text.find(from), from.size(), to);
    return text;
}

StoredReport stored(const std::string& from = {}, const std::string& to = {}) {
    auto report = readStoredReport(reportText(from, to), "r.json");
    EXPECT_TRUE(report) << report.error().message();
    return report ? *report : StoredReport();
}

TEST(StoredReports, AreRead) {
    const StoredReport report = stored();
    EXPECT_EQ(report.mark, 71.5);
    EXPECT_TRUE(report.passes);
    EXPECT_EQ(report.name, "Ann");
    ASSERT_EQ(report.criteria.size(), 2U);
    EXPECT_EQ(report.criteria[0].score, 71.5);
    EXPECT_FALSE(report.criteria[1].score);
    const TrialTrend trend = trialTrend(std::vector{report});
    EXPECT_EQ(trend.trials[0].scores[0].cost, 28.5) << "it has limited the mark";
    EXPECT_EQ(trend.trials[0].scores[1].cost, 0);
}

TEST(StoredReports, AreRefusedIfTheyAreNone) {
    std::string deep = "{\"format\": 1, \"rubric\": ";
    for (int i = 0; i < 100'000; ++i) deep += '[';
    for (const std::string& text :
         {std::string(), std::string("[1]"), std::string("{"), std::string("null"), deep,
          reportText("\"format\": 1", "\"format\": 2"), reportText("71.5, \"pass\"", "1e9, \"pass\""),
          reportText("71.5, \"pass\"", "null, \"pass\""), reportText("\"pass\": true", "\"pass\": 1"),
          reportText("\"pass\": 65", "\"pass\": \"x\""), reportText("\"metric\": \"dice\"", "\"metric\": 3"),
          reportText("\"score\": 71.5", "\"score\": -1")}) {
        const auto report = readStoredReport(text, "r.json");
        ASSERT_FALSE(report) << text.substr(0, 400);
        EXPECT_THAT(report.error().message(), HasSubstr("r.json: this is no report of an assessment"));
    }
}

TEST(StoredReports, CompareOnlyWithTheSameExerciseAndRubric) {
    EXPECT_FALSE(whyNotComparable(stored(), stored("71.5, \"pass\"", "20, \"pass\"")));
    const auto why = [](const StoredReport& one) { return whyNotComparable(one, stored())->in(Language::English); };
    EXPECT_THAT(why(stored("\"Class I\"", "\"Class II\"")), HasSubstr("compared with Class II, not with Class I"));
    EXPECT_THAT(why(stored("\"name\": \"R\"", "\"name\": \"S\"")), HasSubstr("its rubric is S, not R"));
    EXPECT_THAT(why(stored("[0.7, 1]", "[0.8, 1]")), HasSubstr("the rubric R has changed"));
    EXPECT_THAT(why(stored("\"pass\": 65", "\"pass\": 70")), HasSubstr("the rubric R has changed"));
}

TEST(StoredReports, HaveAnOrderOfTime) {
    StoredReport first = stored(), second = stored("27T10", "28T10");
    EXPECT_TRUE(isEarlier(first, second));
    EXPECT_FALSE(isEarlier(second, first));
    EXPECT_TRUE(first.isSameWork(stored()));
    EXPECT_FALSE(first.isSameWork(second));
    first.date = second.date = "";
    first.place = "ann-2/report.json";
    second.place = "ann-10/report.json";
    EXPECT_TRUE(isEarlier(first, second));
    EXPECT_FALSE(first.isSameWork(second)) << "without a date, the same name says nothing";
}

}  // namespace
}  // namespace tactooth
