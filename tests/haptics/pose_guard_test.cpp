// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/pose_guard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace tactooth {
namespace {

constexpr double kTick = 0.001;
constexpr int kDoubtTicks = 101;  // of sound readings until a device is believed again
const double kNan = std::nan("");
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Quat turned(double angle, const Vec3& axis = Vec3::UnitX()) { return Quat(Eigen::AngleAxisd(angle, axis)); }

PoseReading at(const Vec3& place, const Quat& turn = Quat::Identity()) { return {place, turn, 0, true}; }
PoseReading at(double x) { return at(Vec3(x, 0, 0)); }
PoseReading leaning(double angle) { return at(Vec3::Zero(), turned(angle)); }

/// A guard that has believed a hand at rest for a while.
PoseGuard calm(bool touching, const PoseLimits& limits = {}) {
    PoseGuard guard(limits);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(guard.take(at(0), kTick, touching), HandFault::None);
    return guard;
}

/// How many ticks of `next(tick)` pass until the fault is found; 1: in the very one.
template <class Next>
int ticksUntil(HandFault fault, PoseGuard guard, const Next& next, bool touching = true) {
    for (int tick = 1; tick <= 1000; ++tick) {
        const HandFault found = guard.take(next(tick), kTick, touching);
        if (found == fault) return tick;
        EXPECT_EQ(found, HandFault::None);
    }
    return 0;
}

TEST(PoseGuard, WhatIsNoNumberIsAFaultInItsTick) {
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
        for (int axis = 0; axis < 7; ++axis) {
            PoseGuard guard = calm(false);
            PoseReading reading = at(0);
            (axis < 3 ? reading.position[axis] : reading.rotation.coeffs()[axis - 3]) = bad;
            EXPECT_EQ(guard.take(reading, kTick, false), HandFault::NoNumber);
        }
    }
}

TEST(PoseGuard, AQuaternionThatIsNoTurnIsAFaultInItsTick) {
    for (const double length : {0.0, 1e-300, 0.5, 0.9, 0.99, 1.01, 1.1, 2.0, 1e200}) {
        PoseGuard guard = calm(false);
        PoseReading reading = at(0);
        reading.rotation.coeffs() *= length;
        EXPECT_EQ(guard.take(reading, kTick, false), HandFault::BrokenTurn) << length;
    }
    PoseGuard guard = calm(false);
    PoseReading rounded = at(0);
    rounded.rotation.coeffs() *= 1 + 1e-4;
    EXPECT_EQ(guard.take(rounded, kTick, false), HandFault::None);
}

TEST(PoseGuard, AQuaternionAndItsNegativeAreTheSameTurn) {
    std::mt19937 random(20261125);
    std::normal_distribution<double> some;
    for (int i = 0; i < 200; ++i) {
        const Quat turn = Quat(some(random), some(random), some(random), some(random)).normalized();
        PoseGuard guard;
        for (int tick = 0; tick < 20; ++tick) {
            PoseReading reading = at(Vec3::Zero(), turn);
            if (random() % 2 == 0) reading.rotation.coeffs() *= -1;
            ASSERT_EQ(guard.take(reading, kTick, true), HandFault::None);
        }
    }
}

TEST(PoseGuard, ATurnFasterThanAWristIsAFaultInItsTick) {
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0.6, 0, -0.8)}) {
        for (const double speed : {31.0, 50.0, 500.0, 1000 * std::numbers::pi}) {
            const auto next = [&](int tick) { return at(Vec3::Zero(), turned(speed * kTick * tick, axis)); };
            EXPECT_EQ(ticksUntil(HandFault::TurnsTooFast, calm(false), next, false), 1) << speed;
        }
    }
    PoseGuard guard = calm(false);
    for (int tick = 1; tick < 1000; ++tick) ASSERT_EQ(guard.take(leaning(0.029 * tick), kTick, true), HandFault::None);
}

TEST(PoseGuard, ADirectionThatGoesToAndFroIsAFault) {
    for (const double angle : {0.05, 0.6, 1.5, 3.1}) {
        const auto next = [&](int tick) { return leaning(tick % 2 == 0 ? 0 : angle); };
        EXPECT_EQ(ticksUntil(HandFault::TurnsTooFast, calm(false), next, false), 1) << angle;
    }
}

TEST(PoseGuard, ATurnThatIsReadMoreSeldomIsGivenItsTime) {
    PoseLimits limits;
    limits.turnPeriod = 0.02;
    PoseGuard guard = calm(true, limits);
    for (int tick = 1; tick < 1000; ++tick) {  // 10 rad/s, seen every 20 ms
        ASSERT_EQ(guard.take(leaning(0.01 * (tick - tick % 20)), kTick, true), HandFault::None) << tick;
    }
    PoseGuard rested = calm(true, limits);
    for (int tick = 0; tick < 5000; ++tick) (void)rested.take(leaning(0), kTick, true);
    EXPECT_EQ(rested.take(leaning(0.7), kTick, true), HandFault::TurnsTooFast) << "a rest of 5 s is no time to turn";
}

TEST(PoseGuard, AJumpIsAFaultInItsTickAndTouchingASmallerOne) {
    for (const double jump : {10.1, 50.0, 1e5, 1e7, 1e300}) {
        EXPECT_EQ(ticksUntil(
                      HandFault::Jump, calm(false), [&](int) { return at(jump); }, false),
                  1)
            << jump;
    }
    for (const double jump : {2.01, 3.0, 4.9, 9.0}) {
        PoseGuard free = calm(false);
        EXPECT_EQ(free.take(at(jump), kTick, false), HandFault::None) << jump;
        EXPECT_EQ(ticksUntil(HandFault::Jump, calm(true), [&](int) { return at(jump); }), 1) << jump;
        PoseGuard arrives = calm(false);
        EXPECT_EQ(arrives.take(at(jump), kTick, true), HandFault::Jump) << "it comes to touch by the jump";
        PoseGuard leaves = calm(true);
        EXPECT_EQ(leaves.take(at(jump), kTick, false), HandFault::Jump) << "it comes off by the jump";
    }
}

TEST(PoseGuard, AJumpAfterARestIsOneAsWell) {
    PoseGuard guard = calm(true);
    for (int tick = 0; tick < 5000; ++tick) (void)guard.take(at(0), kTick, true);
    EXPECT_EQ(guard.take(at(2.1), kTick, true), HandFault::Jump);
}

TEST(PoseGuard, JitterThatStaysIsAFaultAsLongAsItStays) {
    for (const double size : {1.6, 2.5, 4.9, 20.0}) {
        PoseGuard guard = calm(true);
        for (int tick = 1; tick < 2000; ++tick) {
            const bool touches = tick % 2 == 0;  // only one of the two places is in the tooth
            ASSERT_NE(guard.take(at(tick % 2 == 0 ? 0 : size), kTick, touches), HandFault::None) << tick;
        }
        for (int tick = 1; tick < kDoubtTicks - 1; ++tick) ASSERT_NE(guard.take(at(0), kTick, false), HandFault::None);
        (void)guard.take(at(0), kTick, false);
        EXPECT_EQ(guard.take(at(0), kTick, false), HandFault::None) << "and then the device is believed again";
    }
}

TEST(PoseGuard, DriftFasterThanAHandAtTheToothIsAFaultWithinTwoTicks) {
    for (const double rate : {500.0, 1000.0, 2000.0, 4000.0}) {
        for (const double speed : {1600.0, 3000.0, 4900.0}) {  // mm/s
            PoseGuard guard;
            for (int i = 0; i < 10; ++i) (void)guard.take(at(0), 1 / rate, true);
            double found = 0;
            for (int tick = 1; tick < 100 && found == 0; ++tick) {
                if (guard.take(at(speed / rate * tick), 1 / rate, true) != HandFault::None) found = tick / rate;
            }
            EXPECT_GT(found, 0) << rate << ' ' << speed;
            EXPECT_LE(found, 0.002) << rate << ' ' << speed;
        }
    }
}

TEST(PoseGuard, AQuickHandInTheAirAndABriskOneAtTheToothAreNone) {
    PoseGuard free = calm(false);
    for (int tick = 1; tick < 1000; ++tick) ASSERT_EQ(free.take(at(4.0 * tick), kTick, false), HandFault::None);
    PoseGuard touching = calm(true);
    for (int tick = 1; tick < 1000; ++tick) ASSERT_EQ(touching.take(at(1.4 * tick), kTick, true), HandFault::None);
}

/// A hand that slides with 0.5 m/s, read by a clock that ticks as it likes.
TEST(PoseGuard, AClockThatTicksUnevenlyMakesNoFault) {
    std::mt19937 random(20261125);
    std::uniform_real_distribution<double> wait(0.0001, 0.0028);
    PoseGuard guard = calm(true);
    double time = 0;
    for (int tick = 1; tick < 20000; ++tick) {
        const double elapsed = wait(random);
        time += elapsed;
        ASSERT_EQ(guard.take(at(500 * time), elapsed, true), HandFault::None) << tick;
    }
}

/// Readings come a millisecond apart, and are seen at ticks that now find two of them and now none.
TEST(PoseGuard, TheTimeOfAReadingCountsAndNotThatOfTheTick) {
    PoseGuard guard;
    for (int tick = 1; tick < 5000; ++tick) {
        const double now = kTick * tick;
        const int reading = tick - tick % 3;  // every third tick; it is up to 2 ms old
        const bool isFresh = tick % 3 == 0;
        const double age = now - kTick * reading + 0.0002;
        ASSERT_EQ(guard.take({Vec3(0.5 * reading, 0, 0), Quat::Identity(), age, isFresh}, kTick, true), HandFault::None)
            << tick;
    }
}

TEST(PoseGuard, AReadingThatIsOldIsAFault) {
    for (const double age : {0.0051, 0.02, 1.0, 1e9, kInfinity, kNan, -0.5, -kInfinity}) {
        PoseGuard guard = calm(false);
        PoseReading reading = at(0);
        reading.age = age;
        EXPECT_EQ(guard.take(reading, kTick, false), HandFault::Stale) << age;
        reading.age = 0.004;
        for (int tick = 0; tick < kDoubtTicks; ++tick) (void)guard.take(reading, kTick, false);
        EXPECT_EQ(guard.take(reading, kTick, false), HandFault::None);
    }
}

TEST(PoseGuard, JudgingSaysWhatTakingWouldAndChangesNothing) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> part(-1, 1);
    PoseGuard guard;
    double place = 0;
    for (int tick = 0; tick < 20000; ++tick) {
        place += random() % 500 == 0 ? 5 * part(random) : 0.3 * part(random);
        PoseReading reading = at(Vec3(place, 0, 0), turned(0.02 * part(random)));
        if (random() % 1000 == 0) reading.rotation.coeffs() *= 1.5;
        const bool touching = random() % 2 == 0;
        const HandFault judged = guard.judge(reading, kTick, touching);
        ASSERT_EQ(guard.judge(reading, kTick, touching), judged);
        ASSERT_EQ(guard.take(reading, kTick, touching), judged == HandFault::None ? HandFault::None : judged) << tick;
    }
}

TEST(PoseGuard, WithoutBoundsOnlyWhatIsNoNumberIsAFault) {
    PoseGuard guard(PoseLimits::unbound());
    (void)guard.take(at(0), kTick, true);
    PoseReading far = at(Vec3(1e5, 0, 0), turned(3));
    far.age = 100;
    EXPECT_EQ(guard.take(far, kTick, true), HandFault::None);
    far.position.x() = kNan;
    EXPECT_EQ(guard.take(far, kTick, true), HandFault::NoNumber);
}

TEST(PoseGuard, TheSpeedIsThatOfTheHand) {
    PoseGuard guard = calm(true);
    for (int tick = 1; tick < 50; ++tick) (void)guard.take(at(0.25 * tick), kTick, true);
    EXPECT_NEAR(guard.speed(), 250, 1e-6);
}

TEST(PoseGuard, AClockThatTellsNonsenseIsNoReasonToBelieve) {
    for (const double elapsed : {kNan, kInfinity, -1.0}) {
        PoseGuard guard = calm(true);
        (void)guard.take(at(50), kTick, true);
        EXPECT_NE(guard.take(at(50), elapsed, true), HandFault::None);
        EXPECT_NE(guard.take(at(50), kTick, true), HandFault::None);
    }
}

}  // namespace
}  // namespace tactooth
