// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/learning_curve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tactooth {
namespace {

std::vector<Trial> trials(std::string_view letters) {
    std::vector<Trial> result;
    for (const char c : letters) result.push_back(c == 'f' ? Trial::Failed : Trial::Passed);
    return result;
}

TEST(Cusum, HasThePublishedSteps) {
    struct Row {
        CusumRates rates;
        double step, limit;
        std::size_t cleanTrials;
    };
    for (const Row& row :
         {Row{{0.05, 0.15}, 0.0919, 1.816, 20}, {{0.1, 0.2}, 0.145, 2.71, 19}, {{0.04, 0.08}, 0.058, 2.99, 52}}) {
        const auto plan = planCusum(row.rates);
        ASSERT_TRUE(plan);
        EXPECT_NEAR(plan->step, row.step, 0.0005);
        EXPECT_NEAR(plan->lower, row.limit, 0.005);
        EXPECT_NEAR(plan->upper, row.limit, 0.005);
        EXPECT_EQ(plan->cleanTrials(), row.cleanTrials);
        const auto points = cusumOf(*plan, std::vector<Trial>(row.cleanTrials, Trial::Passed));
        EXPECT_EQ(points.back().decision, CusumDecision::Acceptable);
        EXPECT_EQ(points[points.size() - 2].decision, CusumDecision::None);
    }
}

TEST(Cusum, HasALimitForEachRisk) {
    const auto plan = planCusum({0.05, 0.15, 0.05, 0.2});
    ASSERT_TRUE(plan);
    const double scale = std::log(3.0) + std::log(0.95 / 0.85);
    EXPECT_NEAR(plan->lower, std::log(0.95 / 0.2) / scale, 1e-12);
    EXPECT_NEAR(plan->upper, std::log(0.8 / 0.05) / scale, 1e-12);
}

TEST(Cusum, RisesWithFailuresAndStartsAnewAfterADecision) {
    const auto plan = planCusum({0.05, 0.15});
    ASSERT_TRUE(plan);
    const auto points = cusumOf(*plan, trials("fpffp"));
    EXPECT_NEAR(points[0].sum, 1 - plan->step, 1e-12);
    EXPECT_NEAR(points[1].sum, 1 - 2 * plan->step, 1e-12);
    EXPECT_EQ(points[1].decision, CusumDecision::None);
    EXPECT_NEAR(points[2].sum, 2 - 3 * plan->step, 1e-12);
    EXPECT_EQ(points[2].decision, CusumDecision::None);
    EXPECT_EQ(points[3].decision, CusumDecision::Unacceptable);
    EXPECT_NEAR(points[4].sum, -plan->step, 1e-12);
}

/// Each failure is worth ln 3 of a limit of ln 9, in the same unit.
TEST(Cusum, DecidesWhereALimitIsReachedExactly) {
    const auto plan = planCusum({0.05, 0.15});
    ASSERT_TRUE(plan);
    EXPECT_EQ(cusumOf(*plan, trials("ff"))[1].decision, CusumDecision::Unacceptable);
}

TEST(Cusum, RefusesRatesThatCannotBeDistinguished) {
    EXPECT_FALSE(planCusum({0.15, 0.05}));
    EXPECT_FALSE(planCusum({0.1, 0.1}));
    EXPECT_FALSE(planCusum({0, 0.1}));
    EXPECT_FALSE(planCusum({0.1, 1}));
    EXPECT_FALSE(planCusum({NAN, 0.1}));
    EXPECT_FALSE(planCusum({0.05, 0.15, 0, 0.1}));
    EXPECT_FALSE(planCusum({0.05, 0.15, 0.5, 0.5}));
}

TEST(LearningCurve, RarelyTrustsAStudentWhoCannotDoIt) {
    for (const std::size_t planned : {20U, 50U, 100U}) {
        const auto plan = planLearning(0.1, 0.3, planned);
        ASSERT_TRUE(plan);
        const double falseAlarms = shareThatLearns(*plan, 0.3, 991);
        EXPECT_LE(falseAlarms, 0.051) << planned;
        EXPECT_GE(falseAlarms, 0.02) << planned;  // no stricter than it must be
        EXPECT_GT(shareThatLearns(*plan, 0.1, 992), 4 * falseAlarms) << planned;
        EXPECT_GT(shareThatLearns(*plan, 0.02, 993), 0.75) << planned;
    }
}

TEST(LearningCurve, HasTheSameLimitEachTime) {
    EXPECT_EQ(planLearning(0.1, 0.3, 40)->limit, planLearning(0.1, 0.3, 40)->limit);
    EXPECT_LT(planLearning(0.1, 0.3, 20)->limit, planLearning(0.1, 0.3, 80)->limit);
}

TEST(LearningCurve, NeverFallsBelowZeroAndSaysWhenItIsLearnt) {
    const auto plan = planLearning(0.1, 0.3, 40);
    ASSERT_TRUE(plan);
    EXPECT_NEAR(plan->passed, std::log(0.9 / 0.7), 1e-12);
    EXPECT_NEAR(plan->failed, std::log(0.1 / 0.3), 1e-12);
    const auto beginner = learningCurve(*plan, trials("pfffp"));
    EXPECT_NEAR(beginner.sums[0], plan->passed, 1e-12);
    EXPECT_EQ(beginner.sums[1], 0);
    EXPECT_EQ(beginner.sums[3], 0);
    EXPECT_FALSE(beginner.learntAt);
    const std::size_t needed = plan->cleanTrials();
    EXPECT_EQ(learningCurve(*plan, std::vector<Trial>(needed, Trial::Passed)).learntAt, needed - 1);
    EXPECT_FALSE(learningCurve(*plan, std::vector<Trial>(needed - 1, Trial::Passed)).learntAt);
}

TEST(LearningCurve, RefusesAPlanThatCannotShowAnything) {
    EXPECT_FALSE(planLearning(0.1, 0.3, 5));  // one in six who cannot do it passes five in a row
    EXPECT_TRUE(planLearning(0.1, 0.3, 9));   // one in twenty-five passes nine
    EXPECT_FALSE(planLearning(0.3, 0.1, 20));
    EXPECT_FALSE(planLearning(0.1, 0.3, 0));
    EXPECT_FALSE(planLearning(0.1, 0.3, 1001));
    EXPECT_FALSE(planLearning(0.1, 0.3, 20, 0));
    EXPECT_FALSE(planLearning(NAN, 0.3, 20));
}

}  // namespace
}  // namespace tactooth
