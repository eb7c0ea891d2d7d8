// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/tooth_chart_layout.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

namespace tactooth {
namespace {

const ToothChartLayout& layout() {
    static const ToothChartLayout made = toothChartLayout();
    return made;
}

const ChartTooth& tooth(int fdi) {
    for (const ChartTooth& each : layout().teeth) {
        if (each.fdi == fdi) return each;
    }
    ADD_FAILURE() << fdi;
    return layout().teeth.front();
}

/// Even-odd rule.
bool contains(const std::vector<Vec2>& outline, const Vec2& place) {
    bool inside = false;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Vec2 &a = outline[i], &b = outline[j];
        if ((a.y() > place.y()) == (b.y() > place.y())) continue;
        if (place.x() < a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
    return inside;
}

TEST(ToothChartLayout, HasAll32TeethInsideTheChart) {
    std::set<int> numbers;
    for (const ChartTooth& each : layout().teeth) {
        numbers.insert(each.fdi);
        for (const Vec2& corner : each.outline) {
            EXPECT_TRUE((corner.array() > 0).all() && (corner.array() < layout().size.array()).all()) << each.fdi;
        }
    }
    EXPECT_EQ(numbers.size(), 32U);
    EXPECT_TRUE(numbers.contains(18) && numbers.contains(31) && !numbers.contains(19));
}

TEST(ToothChartLayout, ThePatientsRightIsOnTheLeftAndTheUpperJawAbove) {
    const double middle = layout().size.x() / 2;
    for (const ChartTooth& each : layout().teeth) {
        const int quadrant = each.fdi / 10;
        EXPECT_EQ(each.centre.x() < middle, quadrant == 1 || quadrant == 4) << each.fdi;
        EXPECT_EQ(each.centre.y() < layout().size.y() / 2, quadrant <= 2) << each.fdi;
    }
    EXPECT_LT(tooth(11).centre.y(), tooth(18).centre.y());
    EXPECT_GT(tooth(41).centre.y(), tooth(48).centre.y());
    EXPECT_LT(tooth(11).outward.y(), -0.9);
    EXPECT_GT(tooth(31).outward.y(), 0.9);
    EXPECT_NEAR(tooth(16).centre.x() + tooth(26).centre.x(), layout().size.x(), 1e-9);
}

TEST(ToothChartLayout, NoToothOverlapsAnother) {
    for (const ChartTooth& each : layout().teeth) {
        EXPECT_TRUE(contains(each.outline, each.centre)) << each.fdi;
        int inOthers = 0;
        for (const ChartTooth& other : layout().teeth) {
            if (other.fdi == each.fdi) continue;
            EXPECT_FALSE(contains(other.outline, each.centre)) << each.fdi << " " << other.fdi;
            for (const Vec2& corner : each.outline) inOthers += contains(other.outline, corner) ? 1 : 0;
        }
        EXPECT_EQ(inOthers, 0) << each.fdi;
    }
}

TEST(ToothChartLayout, MolarsAreLargerThanPremolarsAndThoseThanLowerIncisors) {
    const auto area = [](int fdi) {
        double doubled = 0;
        const std::vector<Vec2>& corners = tooth(fdi).outline;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
            doubled += a.x() * b.y() - a.y() * b.x();
        }
        return std::abs(doubled) / 2;
    };
    EXPECT_GT(area(46), 1.5 * area(45));
    EXPECT_GT(area(45), 1.3 * area(41));
    EXPECT_GT(area(11), 1.3 * area(12));
}

TEST(ToothChartLayout, ArrowsReachEveryToothFromEveryOther) {
    std::set<int> reached = {46};
    std::vector<int> open = {46};
    while (!open.empty()) {
        const int from = open.back();
        open.pop_back();
        for (const ChartStep step : {ChartStep::Left, ChartStep::Right, ChartStep::Up, ChartStep::Down}) {
            const int to = toothBeside(from, step);
            if (reached.insert(to).second) open.push_back(to);
        }
    }
    EXPECT_EQ(reached.size(), 32U);
    EXPECT_EQ(toothBeside(11, ChartStep::Right), 21);
    EXPECT_EQ(toothBeside(41, ChartStep::Left), 42);
    EXPECT_EQ(toothBeside(16, ChartStep::Down), 46);
    EXPECT_EQ(toothBeside(36, ChartStep::Up), 26);
    EXPECT_EQ(toothBeside(18, ChartStep::Left), 18);
    EXPECT_EQ(toothBeside(38, ChartStep::Right), 38);
    EXPECT_EQ(toothBeside(38, ChartStep::Down), 38);
}

}  // namespace
}  // namespace tactooth
