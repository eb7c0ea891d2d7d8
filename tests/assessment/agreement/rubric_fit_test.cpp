// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/rubric_fit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "assessment/agreement/made_up_class.h"
#include "assessment/agreement/range_widening.h"

namespace tactooth {
namespace {

using namespace test;

using Ranges = std::array<LevelRanges::Range, 4>;

TEST(RangeWidening, MovesTwoSidesAwayFromTheMiddle) {
    const LevelRanges depth(Ranges{{{1.5, 2}, {1.3, 2.1}, {1, 2.3}, {0.75, 2.5}}});
    const LevelRanges wide = widened(depth, 2);
    EXPECT_EQ(wide.ranges()[0], (LevelRanges::Range{1.25, 2.25}));
    EXPECT_EQ(wide.ranges()[3], (LevelRanges::Range{-0.25, 3.25}));
    // The middle is 1.75: a value twice as far away from it has the same score.
    for (double off = 0; off < 1; off += 0.01) {
        EXPECT_NEAR(wide.scoreOf(1.75 + 2 * off), depth.scoreOf(1.75 + off), 1e-9);
        EXPECT_NEAR(wide.scoreOf(1.75 - 2 * off), depth.scoreOf(1.75 - off), 1e-9);
    }
}

TEST(RangeWidening, LeavesASideWithoutALimit) {
    const LevelRanges over = widened(LevelRanges(Ranges{{{0, 0.15}, {0, 0.3}, {0, 0.5}, {0, 1}}}), 1.2);
    EXPECT_FALSE(over.hasLowerLimit());
    EXPECT_NEAR(over.ranges()[0].high, 0.18, 1e-9);
    EXPECT_NEAR(over.ranges()[3].high, 1.2, 1e-9);
    // The dentin left over the pulp: the far end of 100 mm says only that there is no limit.
    const LevelRanges dentin = widened(LevelRanges(Ranges{{{0.5, 100}, {0.4, 100}, {0.25, 100}, {0, 100}}}), 0.5);
    EXPECT_FALSE(dentin.hasUpperLimit());
    EXPECT_EQ(dentin.ranges()[0], (LevelRanges::Range{0.75, 100}));
    EXPECT_EQ(dentin.ranges()[3], (LevelRanges::Range{0.5, 100}));
}

TEST(RangeWidening, KeepsTheEndsInOrder) {
    SeededRandom random(1);
    for (int trial = 0; trial < 2000; ++trial) {
        const double scale = std::pow(10.0, 4 - 8 * random.share());
        Ranges ranges{};
        ranges[0] = {-scale * random.share(), scale * random.share()};
        const bool isLow = random.below(3) > 0, isHigh = random.below(3) > 0;
        for (std::size_t i = 1; i < 4; ++i) {
            ranges[i].low = ranges[i - 1].low - (isLow ? scale * (0.01 + random.share()) : 0);
            ranges[i].high = ranges[i - 1].high + (isHigh ? scale * (0.01 + random.share()) : 0);
        }
        ASSERT_TRUE(LevelRanges::areNested(ranges));
        const LevelRanges changed = widened(LevelRanges(ranges), 0.5 + 1.5 * random.share());
        EXPECT_TRUE(LevelRanges::areNested(changed.ranges())) << trial;
        EXPECT_EQ(changed.hasLowerLimit(), isLow);
        EXPECT_EQ(changed.hasUpperLimit(), isHigh);
    }
}

/// Works with the marks that a rubric gives them.
struct Examples {
    Examples(const Rubric& rubric, std::size_t count, std::uint64_t seed) : works(madeUpWorks(count, 1, seed)) {
        for (const MeasuredWork& each : works)
            all.push_back({&each.results, markOf(rubric, each.results).value.value()});
    }
    std::vector<MeasuredWork> works;
    std::vector<FitExample> all;
};

double squaredError(const Rubric& rubric, const std::vector<FitExample>& examples) {
    double sum = 0;
    for (const FitExample& each : examples) sum += std::pow(*markOf(rubric, *each.results).value - each.mark, 2);
    return sum;
}

TEST(RubricFit, StaysWhereTheMarksAreThoseOfTheStart) {
    const Rubric start = madeUpRubric({4, 3, 2, 1});
    const RubricFit fit = fitRubric(start, Examples(start, 40, 1).all);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(fit.criteria[i].weight, 10 * start.criteria[i].weight, 0.3);
        EXPECT_EQ(fit.criteria[i].widening, 1);
        EXPECT_EQ(fit.rubric.criteria[i].levels.ranges(), start.criteria[i].levels.ranges());
    }
}

TEST(RubricFit, FindsTheRubricBehindExactMarks) {
    const Rubric truth = madeUpRubric({45, 30, 20, 5}, 1.3), start = madeUpRubric({25, 25, 25, 25});
    const Examples examples(truth, 3000, 2);
    const RubricFit fit = fitRubric(start, examples.all);
    const std::array<double, 4> wanted = {45, 30, 20, 5};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(fit.criteria[i].weight, wanted[i], 2) << i;
    EXPECT_NEAR(fit.criteria[0].widening, 1.3, 0.051);
    for (std::size_t i = 1; i < 3; ++i) EXPECT_NEAR(fit.criteria[i].widening, 1, 0.051) << i;
    EXPECT_LT(squaredError(fit.rubric, examples.all), 0.01 * squaredError(start, examples.all));
}

TEST(RubricFit, HasWeightsInTenthsThatSumUpToAHundred) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Examples examples(madeUpRubric({25, 25, 25, 25}), 12, seed);
        SeededRandom random(seed);
        for (FitExample& each : examples.all) each.mark = 100 * random.share();
        const RubricFit fit = fitRubric(madeUpRubric({1, 2, 3, 0.1}), examples.all);
        double tenths = 0;
        for (const CriterionFit& each : fit.criteria) {
            EXPECT_GE(each.weight, 0);
            EXPECT_NEAR(10 * each.weight, std::round(10 * each.weight), 1e-9);
            tenths += std::round(10 * each.weight);
        }
        EXPECT_EQ(tenths, 1000);
    }
}

TEST(RubricFit, LeavesOutACriterionThatTheTeachersDoNotWeigh) {
    const Rubric truth = madeUpRubric({60, 40, 0.001, 0.001}), start = madeUpRubric({50, 40, 2, 8});
    const RubricFit fit = fitRubric(start, Examples(truth, 800, 3).all);
    EXPECT_EQ(fit.criteria[2].weight, 0);
    EXPECT_EQ(fit.criteria.size(), 4U);
    EXPECT_LT(fit.rubric.criteria.size(), 4U);
    for (const Criterion& each : fit.rubric.criteria) EXPECT_GT(each.weight, 0);
}

constexpr std::string_view kGuards =
    "[[criterion]]\nmetric = \"pulp_open\"\ncritical = true\nideal = [0, 0]\ncorrect = [0, 0.5]\nzero = [0, 1]\n"
    "[[criterion]]\nmetric = \"dice\"\nweight = 10\nlimits_mark = true\nideal = [0.9, 1]\ncorrect = [0.7, 1]\n"
    "zero = [0.2, 1]\n";

TEST(RubricFit, KeepsWhatLimitsTheMark) {
    const Rubric start = madeUpRubric({25, 25, 25, 15}, 1, kGuards);
    Examples examples(madeUpRubric({25, 25, 25, 25}), 60, 4);
    SeededRandom random(4);
    for (std::size_t i = 0; i < examples.works.size(); ++i) {
        setResult(examples.works[i].results, "pulp_open", i % 5 == 0 ? 1 : 0);
        setResult(examples.works[i].results, "dice", 0.5 + 0.5 * random.share());
        examples.all[i].mark = 70 + 30 * random.share();  // teachers who do not mind
    }
    const RubricFit fit = fitRubric(start, examples.all);
    EXPECT_EQ(fit.rubric.passMark, start.passMark);
    EXPECT_EQ(fit.rubric.criticalMark, start.criticalMark);
    EXPECT_EQ(fit.criteria[4].weight, 0);
    int guards = 0;
    for (const Criterion& each : fit.rubric.criteria) {
        const bool isPulp = each.metric->id == "pulp_open", isDice = each.metric->id == "dice";
        EXPECT_EQ(each.critical, isPulp);
        EXPECT_EQ(each.limitsMark, isDice);
        guards += isPulp || isDice ? 1 : 0;
        if (isPulp || isDice) {
            EXPECT_EQ(each.levels.ranges(), start.criteria[isPulp ? 4 : 5].levels.ranges());
        }
    }
    EXPECT_EQ(guards, 2);
    EXPECT_LE(*markOf(fit.rubric, examples.works[0].results).value, start.criticalMark);
}

TEST(RubricFit, NeverWidensWhatIsCritical) {
    const Rubric start = madeUpRubric({20, 10, 10, 10}, 1,
                                      "[[criterion]]\nmetric = \"neighbour_depth_max\"\nweight = 50\ncritical = true\n"
                                      "ideal = [0, 0.05]\ncorrect = [0, 0.2]\nzero = [0, 0.4]\n");
    Rubric generous = start;
    generous.criteria[4].levels = widened(start.criteria[4].levels, 1.5);
    Examples examples(madeUpRubric({25, 25, 25, 25}), 300, 8);
    SeededRandom random(8);
    for (std::size_t i = 0; i < examples.works.size(); ++i) {
        setResult(examples.works[i].results, "neighbour_depth_max", 0.5 * random.share());
        examples.all[i].mark = *markOf(generous, examples.works[i].results).value;
    }
    const RubricFit fit = fitRubric(start, examples.all);
    EXPECT_EQ(fit.criteria[4].widening, 1);
    EXPECT_GT(fit.criteria[4].weight, 10);
    EXPECT_EQ(fit.rubric.criteria.back().levels.ranges(), start.criteria.back().levels.ranges());
}

TEST(RubricFit, KnowsThatLimitsLowerAMark) {
    const Rubric truth = madeUpRubric({45, 25, 10, 10}, 1, kGuards);
    const Rubric start = madeUpRubric({20, 20, 25, 25}, 1, kGuards);
    Examples examples(madeUpRubric({25, 25, 25, 25}), 2000, 9);
    SeededRandom random(9);
    for (std::size_t i = 0; i < examples.works.size(); ++i) {
        // Whose depth is good has overlooked the pulp: read as a mean, such marks would say that depth is a fault.
        const double depth = 1.75 + 0.4 * (2 * random.share() - 1);
        setResult(examples.works[i].results, "floor_depth_median", depth);
        setResult(examples.works[i].results, "pulp_open", std::abs(depth - 1.75) < 0.2 ? 1 : 0);
        setResult(examples.works[i].results, "dice", 0.95);
        examples.all[i].mark = *markOf(truth, examples.works[i].results).value;
    }
    const RubricFit fit = fitRubric(start, examples.all);
    const std::array<double, 4> wanted = {45, 25, 10, 10};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(fit.criteria[i].weight, wanted[i], 6) << i;
}

TEST(RubricFit, TakesWorksOfWhichSomeValuesCannotBeMeasured) {
    const Rubric truth = madeUpRubric({50, 30, 15, 5}), start = madeUpRubric({25, 25, 25, 25});
    Examples examples(truth, 300, 5);
    SeededRandom random(5);
    for (std::size_t i = 0; i < examples.works.size(); ++i) {
        if (random.below(3) == 0) setResult(examples.works[i].results, "floor_depth_median", std::nullopt);
        if (random.below(3) == 0) setResult(examples.works[i].results, "wall_angle_b", std::nullopt);
        examples.all[i].mark = *markOf(truth, examples.works[i].results).value;
    }
    const RubricFit fit = fitRubric(start, examples.all);
    EXPECT_NEAR(fit.criteria[0].weight, 50, 3);
    EXPECT_NEAR(fit.criteria[1].weight, 30, 3);
}

TEST(RubricFit, IsALocalOptimumForTheWeights) {
    // With every value a tenth of a point off, no shift of weight between two criteria gains anything.
    const Rubric start = madeUpRubric({25, 25, 25, 25});
    Examples examples(madeUpRubric({40, 30, 20, 10}), 400, 6);
    SeededRandom random(6);
    for (FitExample& each : examples.all) each.mark += 10 * (random.share() - 0.5);
    const RubricFit fit = fitRubric(start, examples.all);
    const double best = squaredError(fit.rubric, examples.all);
    for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < 4; ++b) {
            if (a == b) continue;
            Rubric other = fit.rubric;
            other.criteria[a].weight += 2;
            other.criteria[b].weight -= 2;
            EXPECT_GT(squaredError(other, examples.all), best) << a << b;
        }
    }
}

}  // namespace
}  // namespace tactooth
