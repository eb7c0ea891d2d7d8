// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/study/synthetic_hand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/servo_tick.h"

namespace tactooth {
namespace {

using test::kTick;

/// A straight groove along x, 4 mm long and 1 mm deep, in a block with its top at z = 0.
HandTask groove() {
    HandTask task;
    std::vector<Vec3> path;
    for (int i = 0; i <= 40; ++i) path.emplace_back(-2 + 0.1 * i, 0, -1);
    task.depths.emplace_back(path.size(), 1.0);
    task.paths.push_back(std::move(path));
    return task;
}

HandHabits calm() { return {.tremor = 0, .delay = 0.1, .force = 1, .layer = 0.4}; }

/// Places of the bur, which follows the hand, one each millisecond, with a constant force on the hand.
std::vector<Vec3> walk(const HandHabits& habits, double force, double longest = 100, std::uint64_t seed = 1) {
    const HandTask task = groove();
    SyntheticHand hand(routeOf(task, habits, seed), task.outward, habits, seed);
    std::vector<Vec3> places;
    while (!hand.isDone() && static_cast<double>(places.size()) * kTick < longest)
        places.push_back(hand.move(kTick, {force, hand.place()}).position);
    return places;
}

TEST(SyntheticHand, TremblesByItsRootMeanSquareAtEightToTwelveHertz) {
    HandHabits still = calm(), trembling = calm();
    trembling.tremor = 0.05;
    const std::vector<Vec3> smooth = walk(still, 0), rough = walk(trembling, 0);
    ASSERT_EQ(smooth.size(), rough.size());
    for (int axis = 0; axis < 3; ++axis) {
        double squares = 0;
        int turns = 0;  // of the sign
        double last = 0;
        for (std::size_t i = 0; i < smooth.size(); ++i) {
            const double shift = rough[i][axis] - smooth[i][axis];
            squares += shift * shift;
            turns += shift * last < 0;
            last = shift;
        }
        const auto count = static_cast<double>(smooth.size());
        EXPECT_NEAR(std::sqrt(squares / count), 0.05, 0.012);
        const double frequency = turns / 2.0 / (count * kTick);
        EXPECT_GT(frequency, 7.5);
        EXPECT_LT(frequency, 12.5);
    }
    EXPECT_EQ(rough, walk(trembling, 0));
    EXPECT_NE(rough, walk(trembling, 0, 100, 2));
}

TEST(SyntheticHand, HoldsBackAtTheForceThatItAccepts) {
    const auto seconds = [](double force) { return static_cast<double>(walk(calm(), force).size()) * kTick; };
    const double free = seconds(0);
    EXPECT_NEAR(seconds(0.14), free, 0.01) << "less than half of what it accepts where it turns does not slow the hand";
    EXPECT_GT(seconds(0.4), free + 1) << "where it turns it accepts less";
    EXPECT_GT(seconds(0.75), 1.5 * free);
    EXPECT_GT(seconds(0.99), 10 * free) << "at this force it stands, and gives up one station after the other";
}

/// The force begins with the first touch of the tooth: the hand goes on for its delay, and no longer.
TEST(SyntheticHand, AnswersAsLateAsItsDelay) {
    for (const double delay : {0.1, 0.35}) {
        HandHabits habits = calm();
        habits.delay = delay;
        const HandTask task = groove();
        SyntheticHand hand(routeOf(task, habits, 1), task.outward, habits, 1);
        Vec3 last = Vec3::Zero();
        double touched = -1, stopped = -1;
        for (int i = 0; i < 5000 && stopped < 0; ++i) {
            const bool touches = touched >= 0 || last.z() < -0.1;
            const Vec3 place = hand.move(kTick, {touches && i > 0 ? habits.force : 0, hand.place()}).position;
            if (touches && touched < 0 && i > 0) touched = i * kTick;
            if (touched >= 0 && place == last) stopped = i * kTick;
            last = place;
        }
        EXPECT_NEAR(stopped - touched, delay, 0.003);
    }
}

/// The tooth holds the bur half a millimetre above the hand: the hand goes on until the bur is at the floor.
TEST(SyntheticHand, PressesOnUntilTheBurIsThere) {
    const HandHabits habits = calm();
    const HandTask task = groove();
    SyntheticHand hand(routeOf(task, habits, 1), task.outward, habits, 1);
    double lowestBur = 0;
    for (int i = 0; i < 100000 && !hand.isDone(); ++i) {
        const Vec3 held = hand.place() + (hand.place().z() < -0.2 ? Vec3(0, 0, 0.5) : Vec3(0, 0, 0));
        lowestBur = std::min(lowestBur, held.z());
        (void)hand.move(kTick, {0.14, held});
    }
    EXPECT_TRUE(hand.isDone());
    EXPECT_NEAR(lowestBur, -1, 0.06);
}

/// A spring leads the bur behind the hand, 2.5 mm/s for each newton: the bur does not go on beyond both ends of the
/// groove and its floor when the hand turns.
TEST(SyntheticHand, EasesItsForceWhereItTurns) {
    constexpr double kStiffness = 1, kRate = 2.5;  // N/mm, mm/(s N)
    const HandHabits habits = calm();
    const HandTask task = groove();
    SyntheticHand hand(routeOf(task, habits, 1), task.outward, habits, 1);
    Vec3 bur = hand.place();
    double lowest = 0, farthest = 0, hardest = 0;
    while (!hand.isDone()) {
        const bool cuts = bur.z() < 0;
        const Vec3 stretch = hand.place() - bur;
        bur = cuts ? Vec3(bur + kRate * kStiffness * kTick * stretch) : hand.place();
        const double force = cuts ? kStiffness * stretch.norm() : 0;
        (void)hand.move(kTick, {force, bur});
        lowest = std::min(lowest, bur.z());
        farthest = std::max(farthest, std::abs(bur.x()));
        hardest = std::max(hardest, force);
    }
    EXPECT_GT(hardest, 0.7 * habits.force);
    EXPECT_NEAR(lowest, -1, 0.1);
    EXPECT_NEAR(farthest, 2, 0.1);
}

}  // namespace
}  // namespace tactooth
