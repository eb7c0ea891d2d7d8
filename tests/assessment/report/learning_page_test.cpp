// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/learning_page.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace tactooth {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Published rates of CUSUM, 5 and 15 %, and 10 and 40 % of LC-CUSUM within 30 trials.
LearningTest usual() {
    const CusumRates rates{0.05, 0.15};
    return {rates, *planCusum(rates), 0.1, *planLearning(0.1, 0.4, 30)};
}

/// Trials of one student: p passed, f failed.
std::vector<StoredReport> trials(const std::string& name, const std::string& results) {
    std::vector<StoredReport> reports;
    for (std::size_t i = 0; i < results.size(); ++i) {
        reports.push_back({.place = "r" + std::to_string(i),
                           .student = "session.ttsession",
                           .name = name,
                           .date = "2026-11-" + std::to_string(10 + i),
                           .expert = "Class I <cavity>",
                           .rubric = "R",
                           .ranges = {},
                           .mark = 70,
                           .passes = results[i] == 'p',
                           .criteria = {}});
    }
    return reports;
}

TEST(LearningPage, ShowsWhoHasLearntIt) {
    const LearningTest test = usual();
    const std::size_t clean = test.learning.cleanTrials();
    const auto learnt = learningOf(trials("Ann", std::string(clean, 'p')), test);
    ASSERT_EQ(learnt.size(), 1U);
    EXPECT_EQ(learnt[0].curve.learntAt, clean - 1);
    EXPECT_THAT(learningTexts(learnt[0], test, Language::English)[0],
                HasSubstr("Learnt: trial " + std::to_string(clean) + " reached the limit"));
    const auto open = learningOf(trials("Ann", std::string(clean - 2, 'p')), test);
    EXPECT_THAT(learningTexts(open[0], test, Language::English)[0], HasSubstr("needs at least 2 more passed trials"));
    const auto failed = learningOf(trials("Ann", "ffffff"), test);
    EXPECT_THAT(learningTexts(failed[0], test, Language::English)[0],
                HasSubstr("(0 of 6 trials passed): it needs at least " + std::to_string(clean) + " more"));
}

TEST(LearningPage, ShowsWhetherTheRateOfFailuresIsAcceptable) {
    const LearningTest test = usual();  // 20 clean trials say acceptable, two failures at once do not
    const auto texts = [&](const std::string& results) {
        return learningTexts(learningOf(trials("Ann", results), test)[0], test, Language::English)[1];
    };
    EXPECT_THAT(texts(std::string(20, 'p')), HasSubstr("is acceptable; trial 20 has decided it"));
    EXPECT_THAT(texts("fff"), HasSubstr("is not acceptable; trial 2 has decided it"));
    EXPECT_THAT(texts("pppf"), HasSubstr("do not show yet"));
}

TEST(LearningPage, HasAChartForEachStudentAndExercise) {
    std::vector<StoredReport> reports = trials("Ben", "pf");
    for (const StoredReport& each : trials("Ann", "ppp")) reports.push_back(each);
    reports.push_back(reports.back());  // assessed twice
    std::vector<StoredReport> other = trials("Ann", "f");
    other[0].expert = "Class II";
    reports.push_back(other[0]);
    const auto students = learningOf(reports, usual());
    ASSERT_EQ(students.size(), 3U);
    EXPECT_EQ(students[0].name, "Ann");
    EXPECT_EQ(students[0].trials.size(), 3U);
    const std::string html = learningHtml(students, usual(), Language::English);
    EXPECT_THAT(html,
                AllOf(HasSubstr("Ann: Class I &lt;cavity&gt;"), HasSubstr("Ann: Class II"),
                      HasSubstr("fails 10 % of the trials, and one who cannot 40 %"), HasSubstr("within 30 trials"),
                      HasSubstr("CUSUM: 5 % failed trials are acceptable, 15 % are not"), Not(HasSubstr("http")),
                      Not(HasSubstr("nan"))));
    EXPECT_THAT(learningHtml(students, usual(), Language::Japanese),
                AllOf(HasSubstr("習得できたか"), Not(HasSubstr("trials"))));
    const auto json = nlohmann::json::parse(learningJson(students, usual()));
    EXPECT_EQ(json["students"].size(), 3U);
    EXPECT_EQ(json["students"][0]["trials"].size(), 3U);
    EXPECT_TRUE(json["students"][0]["learnt_at"].is_null());
    EXPECT_NEAR(json["cusum"]["step"], 0.0919, 1e-4);
    EXPECT_NEAR(json["students"][0]["trials"][0]["cusum"], -0.0919, 1e-4);
}

}  // namespace
}  // namespace tactooth
