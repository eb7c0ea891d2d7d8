// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/study/study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "assessment/study/study_page.h"

namespace tactooth {
namespace {

using testing::HasSubstr;

TEST(HandHabits, EachGrowsWithTheLevelsAndHasAMetricThatShowsIt) {
    std::set<std::string_view> ids;
    for (const HandHabit& each : handHabits()) {
        EXPECT_TRUE(ids.insert(each.id).second);
        EXPECT_LT(each.at(HandLevel::Expert), each.at(HandLevel::Student)) << each.id;
        EXPECT_LT(each.at(HandLevel::Student), each.at(HandLevel::Beginner)) << each.id;
        EXPECT_FALSE(each.effects[0].metric.empty()) << each.id;
        for (const HabitEffect& effect : each.effects) {
            const bool isKnown = effect.metric.empty() || findPreparationMetric(effect.metric) != nullptr;
            EXPECT_TRUE(isKnown) << effect.metric;
        }
    }
}

TEST(HandHabits, OfManyHandsLieAroundThoseOfTheLevel) {
    const HandHabits usual = usualHabits(HandLevel::Beginner);
    std::set<double> forces;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const HandHabits hand = habitsOfHand(HandLevel::Beginner, seed);
        for (const HandHabit& each : handHabits()) {
            EXPECT_GE(hand.*each.value, 0.85 * (usual.*each.value) - 1e-12);
            EXPECT_LE(hand.*each.value, 1.15 * (usual.*each.value) + 1e-12);
        }
        forces.insert(hand.force);
    }
    EXPECT_EQ(forces.size(), 50U);
}

TEST(StudyHands, AreHandsOfEachLevelAndThoseWithOneHabit) {
    const std::vector<StudyHand> hands = studyHands(3, 7);
    ASSERT_EQ(hands.size(), 9 + 4 * handHabits().size());
    std::set<std::string> names;
    for (const StudyHand& each : hands) {
        EXPECT_TRUE(names.insert(each.name).second) << each.name;
        if (each.varied == nullptr) continue;
        for (const HandHabit& habit : handHabits()) {
            if (&habit == each.varied) continue;
            EXPECT_EQ(each.habits.*habit.value, habit.at(HandLevel::Expert));
        }
    }
    const std::vector<StudyHand> again = studyHands(3, 7), other = studyHands(3, 8);
    for (std::size_t i = 0; i < hands.size(); ++i) EXPECT_EQ(hands[i].seed, again[i].seed);
    EXPECT_NE(hands.front().seed, other.front().seed);
}

/// A study whose metrics follow the habits that they must show, each by a number of its own.
class StudyOfMetrics : public testing::Test {
protected:
    StudyOfMetrics() {
        for (StudyHand& hand : studyHands(4, 1)) {
            StudyTrial trial{std::move(hand), {}, {}};
            for (const PreparationMetric& metric : preparationMetrics())
                trial.metrics.push_back({&metric, Measured::of(1)});
            for (const HandHabit& habit : handHabits()) {
                for (const HabitEffect& effect : habit.effects) {
                    if (effect.metric.empty()) continue;
                    const double amount = trial.hand.habits.*habit.value;
                    of(trial, effect.metric).value =
                        *of(trial, effect.metric).value + (effect.rises ? amount : -amount);
                }
            }
            trial.mark.value = 90 - 20 * static_cast<double>(trial.hand.level);
            report_.trials.push_back(std::move(trial));
        }
        rubric_.name = "Test & rubric";
        report_.rubric = &rubric_;
        report_.exercise = "Class <I>";
    }
    static Measured& of(StudyTrial& trial, std::string_view id) {
        const auto found =
            std::ranges::find(trial.metrics, id, [](const MetricResult& each) { return each.metric->id; });
        return found->measured;
    }
    std::vector<StudyTrial*> of(std::string_view habit) {
        std::vector<StudyTrial*> trials;
        for (StudyTrial& each : report_.trials) {
            if (each.hand.varied != nullptr && each.hand.varied->id == habit) trials.push_back(&each);
        }
        return trials;
    }
    [[nodiscard]] const ShownHabit& shown(std::string_view habit, std::string_view metric) {
        all_ = shownHabits(report_.trials);
        for (const ShownHabit& each : all_) {
            if (each.habit->id == habit && preparationMetrics()[each.metric].id == metric) return each;
        }
        throw std::logic_error("no such effect");
    }

    Rubric rubric_;
    StudyReport report_;
    std::vector<ShownHabit> all_;
};

TEST_F(StudyOfMetrics, PassesWhereEachMetricFollowsItsHabit) {
    EXPECT_TRUE(passesSelfTest(report_.trials));
    EXPECT_EQ(shown("force", "force_mean").tau, 1);
    EXPECT_EQ(shown("undone", "cleared_share").tau, -1);
    EXPECT_EQ(contrastOf(report_.trials, markValue).area, 1);
    EXPECT_THAT(studyResultText(report_, Language::English), HasSubstr("Passed"));
}

TEST_F(StudyOfMetrics, OnePairMayBeInTheWrongOrderButNotTheEnds) {
    const auto trials = of("force");
    ASSERT_EQ(trials.size(), 4U);
    const auto set = [&](std::array<double, 4> values) {
        for (std::size_t i = 0; i < 4; ++i) of(*trials[i], "force_mean").value = values[i];
        return shown("force", "force_mean").isShown;
    };
    EXPECT_TRUE(set({1, 3, 2, 4}));
    EXPECT_FALSE(set({1, 4, 3, 2})) << "three pairs";
    EXPECT_FALSE(set({2, 3, 4, 1})) << "the most is less than the least";
    EXPECT_FALSE(set({1, 1, 1, 1})) << "nothing changes";
    EXPECT_FALSE(passesSelfTest(report_.trials));
    EXPECT_THAT(studyResultText(report_, Language::English), HasSubstr("1 of"));
}

TEST_F(StudyOfMetrics, AMetricThatCannotBeMeasuredForEachHandIsLeftOut) {
    const std::size_t all = shownHabits(report_.trials).size();
    static const MessageText reason{"none", "none", "none"};
    of(*of("wider")[2], "dice") = Measured::none(reason);
    EXPECT_EQ(shownHabits(report_.trials).size(), all - 1);
    EXPECT_THROW((void)shown("wider", "dice"), std::logic_error);
    EXPECT_TRUE(passesSelfTest(report_.trials));
}

TEST_F(StudyOfMetrics, FailsWhereABeginnerHasTheMarkOfAnExpert) {
    for (StudyTrial& each : report_.trials) {
        if (each.hand.name == "beginner-01") each.mark.value = 90;
    }
    EXPECT_FALSE(passesSelfTest(report_.trials));
    EXPECT_LT(contrastOf(report_.trials, markValue).area, 1);
}

TEST_F(StudyOfMetrics, AllPagesSayThatTheHandsAreSynthetic) {
    for (const Language language : {Language::English, Language::Japanese}) {
        const std::string page = studyHtml(report_, language);
        EXPECT_THAT(page, HasSubstr(language == Language::English ? "No person has made these works" : "合成の手"));
        EXPECT_THAT(page, HasSubstr("Class &lt;I&gt;"));
        EXPECT_THAT(page, HasSubstr("Test &amp; rubric"));
        EXPECT_THAT(page, testing::Not(HasSubstr("nan")));
    }
    EXPECT_THAT(studyCsv(report_), testing::StartsWith("synthetic_hand,"));
    const auto json = nlohmann::json::parse(studyJson(report_));
    EXPECT_EQ(json["synthetic"], true);
    EXPECT_EQ(json["passes"], true);
    EXPECT_EQ(json["hands"].size(), report_.trials.size());
    EXPECT_EQ(json["mark"]["median"]["Expert"], 90);
}

TEST_F(StudyOfMetrics, EachRowOfTheTableHasAsManyCells) {
    const std::string csv = studyCsv(report_);
    std::set<std::ptrdiff_t> counts;
    for (std::size_t at = 0; at < csv.size();) {
        const std::size_t end = csv.find('\n', at);
        counts.insert(std::count(csv.begin() + static_cast<std::ptrdiff_t>(at),
                                 csv.begin() + static_cast<std::ptrdiff_t>(end), ','));
        at = end + 1;
    }
    EXPECT_EQ(counts.size(), 1U);
}

}  // namespace
}  // namespace tactooth
