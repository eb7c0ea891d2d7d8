// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/rubric/rubric.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <map>

#include "assessment/preparation/prepared_blocks.h"
#include "assessment/rubric/rubric_file.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using namespace test;

using Ranges = std::array<LevelRanges::Range, 4>;

const LevelRanges kDepth(Ranges{{{1.5, 2}, {1.3, 2.2}, {1, 2.5}, {0.5, 3}}});

TEST(LevelRanges, FallInStraightLinesFromLevelToLevel) {
    EXPECT_EQ(kDepth.scoreOf(1.5), 100);
    EXPECT_EQ(kDepth.scoreOf(2), 100);
    EXPECT_NEAR(kDepth.scoreOf(2.1), 92.5, 1e-9);
    EXPECT_NEAR(kDepth.scoreOf(2.2), 85, 1e-9);
    EXPECT_NEAR(kDepth.scoreOf(2.35), 75, 1e-9);
    EXPECT_NEAR(kDepth.scoreOf(2.5), 65, 1e-9);
    EXPECT_NEAR(kDepth.scoreOf(2.75), 32.5, 1e-9);
    EXPECT_EQ(kDepth.scoreOf(3), 0);
    EXPECT_EQ(kDepth.scoreOf(99), 0);
    EXPECT_NEAR(kDepth.scoreOf(1.3), 85, 1e-9);
    EXPECT_NEAR(kDepth.scoreOf(0.75), 32.5, 1e-9);
    EXPECT_EQ(kDepth.scoreOf(-1), 0);
}

TEST(LevelRanges, NeverLoseALevelToAHundredth) {
    for (double x = 0; x < 4; x += 0.001) {
        EXPECT_LT(std::abs(kDepth.scoreOf(x + 0.01) - kDepth.scoreOf(x)), 2);
    }
}

TEST(LevelRanges, NameTheLevel) {
    EXPECT_EQ(kDepth.levelOf(1.7), Level::Ideal);
    EXPECT_EQ(kDepth.levelOf(1.4), Level::Acceptable);
    EXPECT_EQ(kDepth.levelOf(2.4), Level::Correct);
    EXPECT_EQ(kDepth.levelOf(2.6), Level::Fail);
}

TEST(LevelRanges, MayHaveNoLimitOnOneSide) {
    const LevelRanges most(Ranges{{{0, 0.1}, {0, 0.2}, {0, 0.3}, {0, 0.4}}});
    EXPECT_EQ(most.scoreOf(-5), 100);
    EXPECT_EQ(most.levelOf(-5), Level::Ideal);
    EXPECT_EQ(most.scoreOf(0.4), 0);
    EXPECT_FALSE(LevelRanges::areNested({{{0, 1}, {0, 1}, {0, 2}, {0, 3}}}));
    EXPECT_FALSE(LevelRanges::areNested({{{0, 3}, {0, 2}, {0, 1}, {0, 0.5}}}));
    EXPECT_FALSE(LevelRanges::areNested({{{1, 0}, {1, 0}, {1, 0}, {1, 0}}}));
}

Measured resultFor(const PreparationMetric& metric) {
    if (metric.id == "dice") return Measured::of(0.9);
    if (metric.id == "over_max") return Measured::at(0.35, Vec3(1, 2, 3));
    if (metric.id == "pulp_open") return Measured::of(1);
    return {};
}

std::vector<MetricResult> someResults() {
    std::vector<MetricResult> results;
    for (const PreparationMetric& metric : preparationMetrics()) results.push_back({&metric, resultFor(metric)});
    return results;
}

Rubric rubricOf(const std::string& criteria) {
    auto rubric = parseRubric("name = \"R\"\npass = 60\ncritical_mark = 30\n" + criteria, "r.toml");
    EXPECT_TRUE(rubric) << rubric.error().message();
    return std::move(*rubric);
}

const std::string kDice =
    "[[criterion]]\nmetric = \"dice\"\nweight = 1\nideal = [0.95, 1]\nacceptable = [0.9, 1]\ncorrect = [0.8, 1]\n"
    "zero = [0, 1]\n";
const std::string kOver =
    "[[criterion]]\nmetric = \"over_max\"\nweight = 3\nideal = [0, 0.1]\nacceptable = [0, 0.2]\ncorrect = [0, 0.35]\n"
    "zero = [0, 1]\n";
const std::string kFlat =
    "[[criterion]]\nmetric = \"floor_flatness\"\nweight = 4\nideal = [0, 0.1]\ncorrect = [0, 0.2]\nzero = [0, 1]\n";
const std::string kPulp =
    "[[criterion]]\nmetric = \"pulp_open\"\ncritical = true\nideal = [0, 0]\ncorrect = [0, 0.5]\nzero = [0, 1]\n";

TEST(Mark, IsTheWeightedMeanOfWhatCanBeMeasured) {
    const Rubric rubric = rubricOf(kDice + kOver + kFlat);
    const Mark mark = markOf(rubric, someResults());
    EXPECT_NEAR(*mark.value, (85 + 3 * 65) / 4.0, 0.05);
    EXPECT_TRUE(mark.passes);
    EXPECT_NEAR(mark.judgedShare, 0.5, 1e-9);
    EXPECT_FALSE(mark.criteria[2].score);
    EXPECT_NEAR(mark.criteria[0].lost + mark.criteria[1].lost, 100 - *mark.weighted, 1e-9);
}

TEST(Mark, FailsAfterACriticalError) {
    const Rubric rubric = rubricOf(kDice + kPulp);
    const Mark mark = markOf(rubric, someResults());
    EXPECT_EQ(*mark.value, 30);
    EXPECT_FALSE(mark.passes);
    ASSERT_EQ(mark.limitedBy.size(), 1U);
    EXPECT_EQ(mark.limitedBy[0]->metric->id, "pulp_open");
}

TEST(Mark, IsNothingWhereNothingCanBeMeasured) {
    const Rubric rubric = rubricOf(kFlat);
    const Mark mark = markOf(rubric, someResults());
    EXPECT_FALSE(mark.value);
    EXPECT_FALSE(mark.passes);
}

/// A cavity of 4 x 3 x 2 mm is asked for; the block has a pulp below it.
std::vector<MetricResult> resultsFor(const TriangleMesh& student) {
    Preparation preparation = blockPreparation(student, blockWithBox(-2, 2, -1.5, 1.5, 3));
    preparation.pulps = {std::make_shared<const SurfacePart>(box(Vec3(-1, -1, -3), Vec3(1, 1, 2)))};
    return measureAll(PreparationMeasures(preparation));
}

/// Calls `check(rubric)` with each built-in rubric.
template <class Check>
void forEachRubric(const Check& check) {
    for (const BuiltinRubricText& each : builtinRubricTexts()) {
        SCOPED_TRACE(each.name);
        check(*findRubric(each.name));
    }
}

TEST(BuiltinRubrics, GiveNothingForDoingNothing) {
    const auto results = resultsFor(box(Vec3(-5, -5, -5), Vec3(5, 5, 5)));
    forEachRubric([&](const Rubric& rubric) { EXPECT_EQ(markOf(rubric, results).value, 0); });
}

TEST(BuiltinRubrics, FailWhoRemovesEverything) {
    const auto results = resultsFor(box(Vec3(-5, -5, -5), Vec3(5, 5, 1)));
    forEachRubric([&](const Rubric& rubric) {
        const Mark mark = markOf(rubric, results);
        EXPECT_FALSE(mark.passes);
        EXPECT_LE(*mark.value, 40);
    });
}

/// An access opens the pulp; all other preparations keep away from it.
TEST(BuiltinRubrics, FailWhoOpensThePulpOrFailsToFindIt) {
    const auto opened = resultsFor(blockWithBox(-2, 2, -1.5, 1.5, 1.9));
    const auto closed = resultsFor(blockWithBox(-2, 2, -1.5, 1.5, 3));
    int accesses = 0;
    forEachRubric([&](const Rubric& rubric) {
        const bool isAccess = rubric.name == "Endodontic access";
        accesses += isAccess ? 1 : 0;
        const Mark mark = markOf(rubric, isAccess ? closed : opened);
        EXPECT_FALSE(mark.passes);
        EXPECT_LE(*mark.value, 40);
    });
    EXPECT_EQ(accesses, 1);
}

TEST(BuiltinRubrics, NeverPreferWhoRemovesLess) {
    std::map<std::string, double> before;
    for (const double floor : {4.9, 4.6, 4.2, 3.8, 3.5}) {  // all much shallower than the ideal
        const auto results = resultsFor(blockWithBox(-2, 2, -1.5, 1.5, floor));
        forEachRubric([&](const Rubric& rubric) {
            const double value = *markOf(rubric, results).value;
            EXPECT_GE(value, before[rubric.name]) << floor;
            if (floor > 4.5) {
                EXPECT_LT(value, 50);
            }
            before[rubric.name] = value;
        });
    }
}

TEST(NearIdealRubric, OrdersGoodWorkAboveBadWork) {
    const Rubric rubric = *findRubric("near-ideal");
    const auto cavity = [&](double wide, double deep) {
        return *markOf(rubric, resultsFor(blockWithBox(-2 - wide, 2 + wide, -1.5 - wide, 1.5 + wide, 3 - deep))).value;
    };
    const double best = cavity(0, 0), good = cavity(0.03, 0.03), fair = cavity(0.2, 0.2), poor = cavity(0.35, 0.35);
    EXPECT_EQ(best, 100);
    EXPECT_GE(good, 90);
    EXPECT_GT(good, fair);
    EXPECT_GT(fair, poor);
    EXPECT_GT(poor, cavity(0.6, 0.5));
}

}  // namespace
}  // namespace tactooth
