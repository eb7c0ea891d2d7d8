// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/latency_histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <thread>
#include <vector>

namespace tactooth {
namespace {

TEST(LatencyHistogram, IsZeroWithoutEntries) {
    const auto histogram = std::make_unique<LatencyHistogram>();
    EXPECT_EQ(histogram->total(), 0U);
    EXPECT_EQ(histogram->largest(), 0);
    for (const double q : {0.0, 0.5, 1.0}) EXPECT_EQ(histogram->quantile(q), 0);
}

TEST(LatencyHistogram, QuantilesAreTrueToThreePerCentAndNeverBelow) {
    std::mt19937 random(20260202);
    std::lognormal_distribution<double> duration(3, 2);
    const auto histogram = std::make_unique<LatencyHistogram>();
    std::vector<double> all;
    for (int i = 0; i < 20001; ++i) {
        all.push_back(std::clamp(duration(random), 0.2, 5e7));
        histogram->add(all.back());
    }
    std::sort(all.begin(), all.end());
    for (const double q : {0.01, 0.25, 0.5, 0.9, 0.99, 0.999, 1.0}) {
        const double exact = all[static_cast<std::size_t>(std::ceil(q * 20001)) - 1];
        EXPECT_GE(histogram->quantile(q), exact * (1 - 1e-12)) << q;
        EXPECT_LE(histogram->quantile(q), exact * 1.03) << q;
    }
    EXPECT_EQ(histogram->largest(), all.back());
    EXPECT_EQ(histogram->quantile(1), all.back());
    EXPECT_EQ(histogram->total(), 20001U);
}

TEST(LatencyHistogram, TheZerothQuantileIsTheSmallestEntry) {
    const auto histogram = std::make_unique<LatencyHistogram>();
    for (const double micros : {50.0, 60.0, 70.0}) histogram->add(micros);
    EXPECT_NEAR(histogram->quantile(0), 50, 1.5);
}

TEST(LatencyHistogram, AnythingCanBeAdded) {
    const auto histogram = std::make_unique<LatencyHistogram>();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double odd : {0.0, -1.0, -kInfinity, std::nan(""), 1e-300, 1e300, kInfinity}) histogram->add(odd);
    EXPECT_EQ(histogram->total(), 7U);
    EXPECT_EQ(histogram->largest(), kInfinity);
    EXPECT_LE(histogram->quantile(0.5), 0.11);
}

TEST(LatencyHistogram, ClearForgetsAll) {
    const auto histogram = std::make_unique<LatencyHistogram>();
    histogram->add(10);
    histogram->clear();
    EXPECT_EQ(histogram->total(), 0U);
    EXPECT_EQ(histogram->largest(), 0);
}

TEST(LatencyCounts, EachDurationIsCountedInOneOfAdjoiningRanges) {
    std::mt19937 random(7);
    std::lognormal_distribution<double> duration(3, 2);
    const auto histogram = std::make_unique<LatencyHistogram>();
    for (int i = 0; i < 5000; ++i) histogram->add(duration(random));
    histogram->add(0.01);
    const LatencyCounts counts = histogram->counts();
    std::uint64_t sum = counts.between(0, 1);
    for (double low = 1; low < 1e6; low *= 2) sum += counts.between(low, 2 * low);
    EXPECT_EQ(sum, 5001U);
    EXPECT_EQ(counts.total(), 5001U);
    EXPECT_EQ(counts.between(10, 10), 0U);
}

TEST(LatencyCounts, ARangeHoldsWhatIsWellWithinIt) {
    const auto histogram = std::make_unique<LatencyHistogram>();
    for (const double micros : {30.0, 50.0, 50.0, 90.0, 200.0}) histogram->add(micros);
    EXPECT_EQ(histogram->counts().between(40, 100), 3U);
    EXPECT_EQ(histogram->counts().between(100, 40), 0U) << "an empty one";
}

TEST(LatencyCounts, OctavesHoldEachDurationUnderTheirUpperEdge) {
    std::mt19937 random(20261123);
    std::lognormal_distribution<double> duration(3, 2);
    const auto histogram = std::make_unique<LatencyHistogram>();
    std::vector<double> all;
    for (int i = 0; i < 5000; ++i) {
        all.push_back(std::max(0.11, duration(random)));
        histogram->add(all.back());
    }
    const std::vector<LatencyBin> bins = histogram->counts().octaves();
    ASSERT_FALSE(bins.empty());
    EXPECT_GT(bins.front().count, 0U);
    EXPECT_GT(bins.back().count, 0U);
    std::uint64_t below = 0;
    for (std::size_t i = 0; i < bins.size(); ++i) {
        if (i > 0) {
            EXPECT_DOUBLE_EQ(bins[i].upTo, 2 * bins[i - 1].upTo);
        }
        below += bins[i].count;
        const auto wanted = std::ranges::count_if(all, [&](double micros) { return micros < bins[i].upTo; });
        EXPECT_EQ(below, static_cast<std::uint64_t>(wanted)) << bins[i].upTo;
    }
    EXPECT_EQ(below, 5000U);
}

TEST(LatencyCounts, OctavesAreFromTheFirstToTheLastWithEntries) {
    EXPECT_TRUE(LatencyCounts().octaves().empty());
    const auto histogram = std::make_unique<LatencyHistogram>();
    for (const double micros : {1.0, 5.0, 5.0}) histogram->add(micros);
    const std::vector<LatencyBin> bins = histogram->counts().octaves();
    ASSERT_EQ(bins.size(), 3U);
    EXPECT_NEAR(bins[0].upTo, 1.6, 1e-12);
    EXPECT_EQ(bins[1].count, 0U);
    EXPECT_EQ(bins[2].count, 2U);
    EXPECT_NEAR(bins[2].upTo, 6.4, 1e-12);
    histogram->add(0);
    histogram->add(1e300);
    EXPECT_EQ(histogram->counts().octaves().size(), 30U) << "all that there can be";
}

TEST(LatencyCounts, SinceAMomentHoldsWhatCameAfterIt) {
    const auto histogram = std::make_unique<LatencyHistogram>();
    for (int i = 0; i < 100; ++i) histogram->add(10);
    const LatencyCounts earlier = histogram->counts();
    for (int i = 0; i < 7; ++i) histogram->add(500);
    const LatencyCounts newer = histogram->counts().since(earlier);
    EXPECT_EQ(newer.total(), 7U);
    EXPECT_NEAR(newer.quantile(0.01), 500, 15);
    EXPECT_EQ(earlier.since(earlier).total(), 0U);
    EXPECT_EQ(earlier.since(earlier).quantile(0.5), 0);
}

TEST(LatencyHistogram, OneThreadReadsWhileAnotherAdds) {
    const auto histogram = std::make_unique<LatencyHistogram>();
    constexpr std::uint64_t kEntries = 20000;
    std::jthread writer([&] {
        for (std::uint64_t i = 0; i < kEntries; ++i) histogram->add(100);
    });
    while (histogram->total() < kEntries) {
        const double middle = histogram->quantile(0.5);
        ASSERT_TRUE(middle == 0 || std::abs(middle - 100) < 3) << middle;
    }
    EXPECT_EQ(histogram->quantile(0.5), 100);
}

}  // namespace
}  // namespace tactooth
