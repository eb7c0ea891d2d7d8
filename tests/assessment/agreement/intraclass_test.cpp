// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/intraclass.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "assessment/agreement/agreement_random.h"

namespace tactooth {
namespace {

// Shrout and Fleiss 1979, table 2: six subjects, four judges.
const std::vector<double> kClassic = {9, 2, 5, 8, 6, 1, 3, 2, 8, 4, 6, 8, 7, 1, 2, 6, 10, 5, 6, 9, 6, 2, 4, 7};

TEST(Intraclass, GivesTheClassicTable) {
    const auto icc = intraclassCorrelation(kClassic, 4);
    ASSERT_TRUE(icc);
    EXPECT_EQ(icc->works, 6U);
    EXPECT_EQ(icc->raters, 4U);
    EXPECT_NEAR(icc->betweenWorks, 11.241667, 1e-6);
    EXPECT_NEAR(icc->betweenRaters, 32.486111, 1e-6);
    EXPECT_NEAR(icc->residual, 1.019444, 1e-6);
    EXPECT_NEAR(icc->withinWorks, 6.263889, 1e-6);
    EXPECT_NEAR(*icc->oneWay, 0.165742, 1e-6);
    EXPECT_NEAR(*icc->agreement, 0.289764, 1e-6);
    EXPECT_NEAR(*icc->consistency, 0.714841, 1e-6);
    EXPECT_NEAR(*icc->meanAgreement, 0.620051, 1e-6);
    EXPECT_NEAR(*icc->meanConsistency, 0.909316, 1e-6);
}

TEST(Intraclass, GivesThePublishedIntervalOfTheClassicTable) {
    const auto icc = intraclassCorrelation(kClassic, 4);
    ASSERT_TRUE(icc && icc->agreementInterval);
    EXPECT_NEAR(icc->agreementInterval->low, 0.019, 0.0005);
    EXPECT_NEAR(icc->agreementInterval->high, 0.761, 0.0005);
}

TEST(Intraclass, DistinguishesARaterWhoIsStricterFromOneWhoDiffers) {
    const std::vector<double> stricter = {2, 4, 4, 6, 6, 8};
    const auto icc = intraclassCorrelation(stricter, 2);
    ASSERT_TRUE(icc);
    EXPECT_NEAR(*icc->consistency, 1, 1e-12);
    EXPECT_NEAR(*icc->agreement, 2.0 / 3, 1e-12);
}

TEST(Intraclass, AgreesWithIndependentSumsOfSquares) {
    SeededRandom random(1);
    for (int trial = 0; trial < 200; ++trial) {
        const std::size_t works = 2 + random.below(20), raters = 2 + random.below(5);
        std::vector<double> ratings(works * raters);
        for (double& each : ratings) each = std::round(100 * random.share());
        // Raw sums of squares: of all, of the works' totals, of the raters' totals, of the grand total.
        double all = 0, grand = 0, byWork = 0, byRater = 0;
        for (std::size_t i = 0; i < works; ++i) {
            double total = 0;
            for (std::size_t j = 0; j < raters; ++j) total += ratings[i * raters + j];
            byWork += total * total / static_cast<double>(raters);
            grand += total;
        }
        for (std::size_t j = 0; j < raters; ++j) {
            double total = 0;
            for (std::size_t i = 0; i < works; ++i) total += ratings[i * raters + j];
            byRater += total * total / static_cast<double>(works);
        }
        for (const double each : ratings) all += each * each;
        const auto n = static_cast<double>(works), k = static_cast<double>(raters);
        const double mean = grand * grand / (n * k);
        const auto icc = intraclassCorrelation(ratings, raters);
        ASSERT_TRUE(icc);
        EXPECT_NEAR(icc->betweenWorks, (byWork - mean) / (n - 1), 1e-6);
        EXPECT_NEAR(icc->betweenRaters, (byRater - mean) / (k - 1), 1e-6);
        EXPECT_NEAR(icc->withinWorks, (all - byWork) / (n * (k - 1)), 1e-6);
        EXPECT_NEAR(icc->residual, (all - byWork - byRater + mean) / ((n - 1) * (k - 1)), 1e-6);
    }
}

TEST(Intraclass, HasAnIntervalThatHoldsTheTruthNineteenTimesOfTwenty) {
    // Works, raters and errors with variances 9, 1 and 4: the true agreement is 9 / 14.
    SeededRandom random(2);
    constexpr int kTables = 1000;
    int held = 0;
    for (int table = 0; table < kTables; ++table) {
        constexpr std::size_t kRaters = 4;
        std::array<double, kRaters> severity{};
        for (double& each : severity) each = test::normal(random);
        std::vector<double> ratings;
        for (int work = 0; work < 20; ++work) {
            const double quality = 3 * test::normal(random);
            for (const double each : severity) ratings.push_back(quality + each + 2 * test::normal(random));
        }
        const auto icc = intraclassCorrelation(ratings, kRaters);
        ASSERT_TRUE(icc && icc->agreementInterval);
        held += icc->agreementInterval->low <= 9.0 / 14 && 9.0 / 14 <= icc->agreementInterval->high ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(held) / kTables, kConfidence, 0.02);
}

TEST(Intraclass, IsNothingWhereNothingVaries) {
    const auto equal = intraclassCorrelation(std::vector<double>(12, 70.1), 3);
    ASSERT_TRUE(equal);
    EXPECT_FALSE(equal->oneWay || equal->agreement || equal->consistency || equal->meanAgreement ||
                 equal->meanConsistency || equal->agreementInterval);
    EXPECT_FALSE(intraclassCorrelation({}, 2));
    EXPECT_FALSE(intraclassCorrelation(std::vector<double>{1, 2}, 2));
    EXPECT_FALSE(intraclassCorrelation(std::vector<double>{1, 2, 3}, 1));
}

TEST(Intraclass, IsOneWhereAllAgreeAndNeverNotANumber) {
    const auto same = intraclassCorrelation(std::vector<double>{0.1, 0.1, 0.7, 0.7, 99.3, 99.3}, 2);
    ASSERT_TRUE(same);
    EXPECT_EQ(same->agreement, 1);
    EXPECT_FALSE(same->agreementInterval);
    SeededRandom random(3);
    for (int trial = 0; trial < 3000; ++trial) {
        std::vector<double> ratings(2 * (2 + random.below(3)));
        for (double& each : ratings) each = static_cast<double>(random.below(3));
        const auto icc = intraclassCorrelation(ratings, 2);
        ASSERT_TRUE(icc);
        for (const auto& each : {icc->oneWay, icc->agreement, icc->consistency, icc->meanAgreement}) {
            EXPECT_TRUE(!each || std::isfinite(*each));
        }
        if (!icc->agreementInterval) continue;
        EXPECT_TRUE(std::isfinite(icc->agreementInterval->low) && std::isfinite(icc->agreementInterval->high));
        EXPECT_LE(icc->agreementInterval->low, *icc->agreement + 1e-9);
        EXPECT_GE(icc->agreementInterval->high, *icc->agreement - 1e-9);
    }
}

}  // namespace
}  // namespace tactooth
