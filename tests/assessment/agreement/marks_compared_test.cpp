// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "assessment/agreement/agreement_random.h"
#include "assessment/agreement/bland_altman.h"
#include "assessment/agreement/failure_detection.h"
#include "assessment/agreement/mark_agreement.h"

namespace tactooth {
namespace {

TEST(BlandAltman, IsItsClosedForm) {
    // Mean 1, deviation sqrt(10 / 4).
    const auto found = blandAltman(std::vector<double>{-1, 0, 1, 2, 3});
    ASSERT_TRUE(found);
    const double deviation = std::sqrt(2.5);
    EXPECT_EQ(found->works, 5U);
    EXPECT_NEAR(found->bias, 1, 1e-12);
    EXPECT_NEAR(found->deviation, deviation, 1e-12);
    EXPECT_NEAR(found->low, 1 - 1.96 * deviation, 1e-12);
    EXPECT_NEAR(found->high, 1 + 1.96 * deviation, 1e-12);
    EXPECT_NEAR(found->biasError, deviation / std::sqrt(5.0), 1e-12);
    EXPECT_NEAR(found->limitError, deviation * std::sqrt(0.6), 1e-12);
    constexpr double kStudent = 2.7764451052;  // tables: 97.5 %, 4 degrees of freedom
    EXPECT_NEAR(found->biasInterval.high, 1 + kStudent * found->biasError, 1e-8);
    EXPECT_NEAR(found->lowInterval.low, found->low - kStudent * found->limitError, 1e-8);
    EXPECT_NEAR(found->highInterval.high, found->high + kStudent * found->limitError, 1e-8);
}

TEST(BlandAltman, NeedsTwoWorksAndTakesEqualOnes) {
    EXPECT_FALSE(blandAltman({}));
    EXPECT_FALSE(blandAltman(std::vector<double>{3}));
    const auto equal = blandAltman(std::vector<double>{3, 3, 3});
    ASSERT_TRUE(equal);
    EXPECT_EQ(equal->low, 3);
    EXPECT_EQ(equal->highInterval, (Interval{3, 3}));
}

TEST(Share, HasWilsonsInterval) {
    // The ends solve (p - share)^2 = z^2 p (1 - p) / n.
    for (const auto& [part, all] : {std::pair(8, 10), {1, 3}, {98, 100}, {12, 50}}) {
        const auto share = shareOf(static_cast<std::size_t>(part), static_cast<std::size_t>(all));
        ASSERT_TRUE(share);
        for (const double end : {share->interval.low, share->interval.high}) {
            const double off = end - static_cast<double>(part) / all;
            EXPECT_NEAR(off * off, 1.959963984540054 * 1.959963984540054 * end * (1 - end) / all, 1e-12);
        }
        EXPECT_LT(share->interval.low, share->value);
        EXPECT_GT(share->interval.high, share->value);
    }
    EXPECT_NEAR(shareOf(8, 10)->interval.low, 0.490162, 1e-6);
    EXPECT_NEAR(shareOf(8, 10)->interval.high, 0.943318, 1e-6);
    EXPECT_EQ(shareOf(0, 5)->interval.low, 0);
    EXPECT_EQ(shareOf(5, 5)->interval.high, 1);
    EXPECT_FALSE(shareOf(0, 0));
}

TEST(FailureDetection, CountsAFailingWorkAsPositive) {
    const std::vector<Outcome> outcomes = {{true, true},  {true, true},   {true, true},  {true, false},
                                           {false, true}, {false, false}, {false, false}};
    const FailureDetection found = failureDetection(outcomes);
    EXPECT_EQ(found.caught, 3U);
    EXPECT_EQ(found.missed, 1U);
    EXPECT_EQ(found.wronglyFailed, 1U);
    EXPECT_EQ(found.bothPass, 2U);
    EXPECT_EQ(found.sensitivity->value, 0.75);
    EXPECT_NEAR(found.specificity->value, 2.0 / 3, 1e-12);
    EXPECT_FALSE(failureDetection(std::vector<Outcome>{{false, true}}).sensitivity);
    EXPECT_FALSE(failureDetection(std::vector<Outcome>{{true, true}}).specificity);
}

TEST(AreaUnderCurve, CountsEachPairAndHalvesTies) {
    SeededRandom random(5);
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<double> upper(1 + random.below(12)), lower(1 + random.below(12));
        for (double& each : upper) each = static_cast<double>(random.below(6) + 2);
        for (double& each : lower) each = static_cast<double>(random.below(6));
        double won = 0;
        for (const double a : upper) {
            for (const double b : lower) won += a > b ? 1 : (a == b ? 0.5 : 0);
        }
        EXPECT_NEAR(*areaUnderCurve(upper, lower), won / static_cast<double>(upper.size() * lower.size()), 1e-12);
    }
    EXPECT_FALSE(areaUnderCurve({}, std::vector<double>{1}));
    EXPECT_FALSE(areaUnderCurve(std::vector<double>{1}, {}));
}

TEST(MarkAgreement, NamesTheLevelOfAMark) {
    EXPECT_EQ(levelOfMark(100), Level::Ideal);
    EXPECT_EQ(levelOfMark(92.5), Level::Ideal);
    EXPECT_EQ(levelOfMark(92.4), Level::Acceptable);
    EXPECT_EQ(levelOfMark(85), Level::Acceptable);
    EXPECT_EQ(levelOfMark(75), Level::Acceptable);
    EXPECT_EQ(levelOfMark(74.9), Level::Correct);
    EXPECT_EQ(levelOfMark(65), Level::Correct);
    EXPECT_EQ(levelOfMark(64.9), Level::Fail);
    EXPECT_EQ(levelOfMark(0), Level::Fail);
}

TEST(MarkAgreement, ComparesTheTeachersWithTheProgram) {
    const std::vector<MarkPair> marks = {{100, 96}, {85, 88}, {70, 72}, {50, 66}, {30, 20}};
    const MarkAgreement found = markAgreement(marks, 65);
    EXPECT_EQ(found.works, 5U);
    EXPECT_NEAR(*found.rms, std::sqrt((16 + 9 + 4 + 256 + 100) / 5.0), 1e-12);
    EXPECT_NEAR(found.difference->bias, 7 / 5.0, 1e-12);
    EXPECT_EQ(found.icc->raters, 2U);
    EXPECT_EQ(found.levels.at(3, 2), 1U);  // the teachers fail what the program would have corrected
    EXPECT_EQ(found.levels.at(3, 3), 1U);
    EXPECT_EQ(found.failures.missed, 1U);
    EXPECT_EQ(found.failures.sensitivity->value, 0.5);
    EXPECT_EQ(found.failures.specificity->value, 1);
    EXPECT_EQ(found.areaUnderCurve, 1);
    ASSERT_TRUE(found.linearKappa && found.quadraticKappa);
    EXPECT_GT(found.quadraticKappa->value, found.linearKappa->value);
}

TEST(MarkAgreement, OfNoWorkIsNothing) {
    const MarkAgreement found = markAgreement({}, 65);
    EXPECT_EQ(found.works, 0U);
    EXPECT_FALSE(found.rms || found.icc || found.difference || found.linearKappa || found.quadraticKappa ||
                 found.areaUnderCurve || found.failures.sensitivity || found.failures.specificity);
}

}  // namespace
}  // namespace tactooth
