// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/study/hand_route.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/util/vec.h"

namespace tactooth {
namespace {

/// Straight grooves along x, 4 mm long and 1 mm deep, in a block with its top at z = 0; `rows`: their places along y,
/// mm.
HandTask grooves(const std::vector<double>& rows) {
    HandTask task;
    for (const double y : rows) {
        std::vector<Vec3> path;
        for (int i = 0; i <= 40; ++i) path.emplace_back(-2 + 0.1 * i, y, -1);
        task.depths.emplace_back(path.size(), 1.0);
        task.paths.push_back(std::move(path));
    }
    return task;
}

/// One hole, 1 mm deep.
HandTask pit() { return {{{Vec3(0, 0, -1)}}, {{1.0}}, Vec3::UnitZ()}; }

HandHabits calm() { return {.tremor = 0, .delay = 0.1, .force = 1, .layer = 2}; }

std::vector<Vec3> placesInTooth(const HandTask& task, const HandHabits& habits) {
    std::vector<Vec3> places;
    for (const HandStation& each : routeOf(task, habits, 1)) {
        if (each.isInTooth) places.push_back(each.tip);
    }
    return places;
}

Box3 boxOf(const std::vector<Vec3>& places) {
    Box3 box;
    for (const Vec3& each : places) box.extend(each);
    return box;
}

TEST(HandRoute, GoesDownInLayersAndEndsAboveTheTooth) {
    for (const double layer : {0.4, 1.2}) {
        HandHabits habits = calm();
        habits.layer = layer;
        const std::vector<HandStation> route = routeOf(grooves({0}), habits, 1);
        std::vector<double> heights;
        for (const HandStation& each : route) {
            if (each.isInTooth && (heights.empty() || heights.back() != each.tip.z())) heights.push_back(each.tip.z());
        }
        const auto layers = static_cast<std::size_t>(std::ceil(1 / layer));
        ASSERT_EQ(heights.size(), layers);
        EXPECT_TRUE(std::ranges::is_sorted(heights, std::ranges::greater()));
        EXPECT_DOUBLE_EQ(heights.back(), -1);
        EXPECT_FALSE(route.back().isInTooth);
        EXPECT_GT(route.back().tip.z(), 1);
    }
}

TEST(HandRoute, GoesDeeperByItsHabit) {
    HandHabits habits = calm();
    EXPECT_NEAR(boxOf(placesInTooth(grooves({0}), habits)).min().z(), -1, 1e-9);
    habits.deeper = 0.3;
    EXPECT_NEAR(boxOf(placesInTooth(grooves({0}), habits)).min().z(), -1.3, 1e-9);
}

TEST(HandRoute, GoesBeyondTheOutlineToAllSides) {
    HandHabits habits = calm();
    habits.wider = 0.25;
    for (const auto& rows : {std::vector<double>{0}, {-0.3, 0, 0.3}}) {
        const std::vector<Vec3> places = placesInTooth(grooves(rows), habits);
        const Box3 box = boxOf(places);
        EXPECT_NEAR((box.min() - Vec3(-2.25, rows.front() - 0.25, -1)).norm(), 0, 1e-9);
        EXPECT_NEAR((box.max() - Vec3(2.25, rows.back() + 0.25, -1)).norm(), 0, 1e-9);
        if (rows.size() < 2) continue;
        EXPECT_EQ(places.size(), rows.size() * 41);
        const auto inside = [](const Vec3& each) { return std::abs(each.y()) < 1e-9; };
        EXPECT_EQ(std::ranges::count_if(places, inside), 41) << "the middle one stays";
    }
}

TEST(HandRoute, GoesAroundALoneHole) {
    HandHabits habits = calm();
    habits.wider = 0.2;
    const std::vector<Vec3> places = placesInTooth(pit(), habits);
    const Box3 box = boxOf(places);
    EXPECT_NEAR((box.min() - Vec3(-0.2, -0.2, -1)).norm(), 0, 1e-9);
    EXPECT_NEAR((box.max() - Vec3(0.2, 0.2, -1)).norm(), 0, 1e-9);
}

/// Also where the path turns back: the end lies elsewhere than the path's last place.
TEST(HandRoute, FindsTheEndsOfAPathThatTurnsBack) {
    HandTask task = grooves({0});
    std::vector<Vec3>& path = task.paths.front();
    std::ranges::rotate(path, path.begin() + 20);  // from the middle to one end, and from the other one to the middle
    std::reverse(path.begin() + 21, path.end());
    HandHabits habits = calm();
    habits.wider = 0.25;
    const Box3 box = boxOf(placesInTooth(task, habits));
    EXPECT_NEAR((box.min() - Vec3(-2.25, -0.25, -1)).norm(), 0, 1e-9);
    EXPECT_NEAR((box.max() - Vec3(2.25, 0.25, -1)).norm(), 0, 1e-9);
}

TEST(HandRoute, LeavesItsShareOfTheLengthUndone) {
    HandHabits habits = calm();
    habits.undone = 0.25;
    habits.layer = 0.4;
    const Box3 box = boxOf(placesInTooth(grooves({-0.3, 0, 0.3}), habits));
    EXPECT_NEAR(box.min().x(), -2, 1e-9);
    EXPECT_NEAR(box.max().x(), 1, 1e-9) << "in each row and each layer";
    EXPECT_NEAR(boxOf(placesInTooth(pit(), habits)).min().z(), -0.75, 1e-9) << "a hole has no length";
    habits.wider = 0.25;
    EXPECT_NEAR(boxOf(placesInTooth(grooves({-0.3, 0, 0.3}), habits)).max().x(), 1, 1e-9);
}

TEST(HandRoute, StraysFromItsPathAsFarAsItsHabitSays) {
    HandHabits habits = calm();
    const std::vector<HandStation> straight = routeOf(grooves({0}), habits, 1);
    habits.uneven = 0.1;
    double squares = 0, count = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const std::vector<HandStation> route = routeOf(grooves({0}), habits, seed);
        ASSERT_EQ(route.size(), straight.size());
        for (std::size_t i = 0; i < route.size(); ++i) {
            const Vec3 off = route[i].tip - straight[i].tip;
            if (!route[i].isInTooth) {
                EXPECT_EQ(off.norm(), 0);
                continue;
            }
            EXPECT_LT(off.cwiseAbs().maxCoeff(), 0.1 * std::sqrt(6.0) + 1e-9);
            squares += off.squaredNorm();
            count += 3;
            // Slowly: a tenth of a millimetre further it is nearly as far off.
            if (route[i - 1].isInTooth && (straight[i].tip - straight[i - 1].tip).norm() < 0.11) {
                EXPECT_LT((off - (route[i - 1].tip - straight[i - 1].tip)).norm(), 0.1);
            }
        }
    }
    EXPECT_NEAR(std::sqrt(squares / count), 0.1, 0.015);
    EXPECT_NE(routeOf(grooves({0}), habits, 1)[5].tip, routeOf(grooves({0}), habits, 2)[5].tip);
}

TEST(HandRoute, StraysLikewiseInEachPass) {
    HandHabits habits = calm();
    habits.uneven = 0.1;
    const std::vector<Vec3> once = placesInTooth(grooves({0}), habits), twice = placesInTooth(grooves({0, 0}), habits);
    ASSERT_EQ(twice.size(), 2 * once.size());
    for (std::size_t i = 0; i < once.size(); ++i) {
        EXPECT_EQ(twice[i], once[i]);
        EXPECT_EQ(twice[i + once.size()], once[i]);
    }
}

}  // namespace
}  // namespace tactooth
