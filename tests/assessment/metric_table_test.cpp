// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/metric_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "assessment/preparation/preparation_metrics.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

const Metric& metric(std::string_view key) {
    for (const Metric& each : metricTable())
        if (each.key == key) return each;
    ADD_FAILURE() << "no metric " << key;
    return metricTable().front();
}

TEST(MetricTable, HasUniqueKeysAndCompleteRows) {
    std::set<std::string_view> keys;
    std::set<std::pair<std::string_view, std::string_view>> rows;
    for (const Metric& each : metricTable()) {
        SCOPED_TRACE(each.key);
        EXPECT_TRUE(keys.insert(each.key).second);
        EXPECT_TRUE(rows.insert({each.quantity, each.shownUnit()}).second);
        EXPECT_TRUE(each.definition.ends_with('.'));
        const std::size_t texts =
            !each.titleEn.empty() + !each.titleJa.empty() + !each.tipEn.empty() + !each.tipJa.empty();
        EXPECT_TRUE(texts == 0 || texts == 4) << "a row of the panel has both languages";
        EXPECT_EQ(each.compute(CavityProgress{}), 0) << "without a cavity";
    }
}

/// Of a metric of a finished preparation: reports have its title and its definition in both languages.
TEST(PreparationMetrics, HaveBothLanguages) {
    const auto isJapanese = [](std::string_view text) {
        return std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) >= 0xE3; });
    };
    std::set<std::string_view> titles;
    for (const PreparationMetric& each : preparationMetrics()) {
        SCOPED_TRACE(each.id);
        EXPECT_TRUE(isJapanese(each.titleIn(Language::Japanese)));
        EXPECT_TRUE(titles.insert(each.titleIn(Language::Japanese)).second) << "two have the same title";
        EXPECT_TRUE(isJapanese(each.definitionIn(Language::Japanese)));
        EXPECT_TRUE(each.definitionIn(Language::Japanese).ends_with("。"));
        EXPECT_EQ(each.titleIn(Language::English), each.title);
        EXPECT_FALSE(isJapanese(each.title));
    }
}

/// A cavity of 8 mm^3, of which 6 are cut, and 2 cut beyond it: 12 of 16 are common.
TEST(MetricTable, ComputesTheClosedForm) {
    const CavityProgress cavity{8, 6, 2, 0.25};
    EXPECT_EQ(metric("ideal_mm3").compute(cavity), 8);
    EXPECT_EQ(metric("cleared_share").compute(cavity), 0.75);
    EXPECT_EQ(metric("beyond_mm3").compute(cavity), 2);
    EXPECT_EQ(metric("deepest_beyond_mm").compute(cavity), 0.25);
    EXPECT_EQ(metric("likeness").compute(cavity), 0.75);
}

TEST(MetricTable, ShowsFractionsInPercent) {
    const CavityProgress cavity{8, 6, 2, 0.25};
    EXPECT_EQ(metric("likeness").shown(cavity), 75);
    EXPECT_EQ(metric("likeness").shownUnit(), "%");
    EXPECT_EQ(metric("beyond_mm3").shown(cavity), 2);
    EXPECT_EQ(metric("beyond_mm3").shownUnit(), "mm^3");
}

/// Moving a metric in its better direction: more of the cavity cut, less beyond it.
TEST(MetricTable, StatesTheBetterDirection) {
    const CavityProgress poor{8, 4, 2, 0.5}, good{8, 7, 1, 0.1};
    for (const Metric& each : metricTable()) {
        SCOPED_TRACE(each.key);
        const double change = each.compute(good) - each.compute(poor);
        switch (each.better) {
            case Better::Higher:
                EXPECT_GT(change, 0);
                break;
            case Better::Lower:
                EXPECT_LT(change, 0);
                break;
            case Better::Neither:
                EXPECT_EQ(change, 0);
                break;
        }
    }
}

TEST(MetricTable, DocumentsEachMetric) {
    for (const Language language : {Language::English, Language::Japanese}) {
        const std::string page = metricsPage(language);
        for (const Metric& each : metricTable()) {
            EXPECT_NE(each.definitionIn(language), "") << each.key;
            EXPECT_THAT(page, HasSubstr("`" + std::string(each.key) + "`"));
            EXPECT_THAT(page, HasSubstr(std::string(each.definitionIn(language))));
        }
    }
}

}  // namespace
}  // namespace tactooth
