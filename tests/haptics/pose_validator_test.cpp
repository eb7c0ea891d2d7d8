// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/pose_validator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "support/servo_tick.h"

namespace tactooth {
namespace {

using test::kTick;
constexpr int kFaultHoldTicks = 101;  // of valid readings until a device counts as valid again
const double kNan = std::nan("");
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Quat turned(double angle, const Vec3& axis = Vec3::UnitX()) { return Quat(Eigen::AngleAxisd(angle, axis)); }

PoseReading at(const Vec3& place, const Quat& turn = Quat::Identity()) { return {place, turn, 0, true}; }
PoseReading at(double x) { return at(Vec3(x, 0, 0)); }
PoseReading leaning(double angle) { return at(Vec3::Zero(), turned(angle)); }

/// A validator that has accepted a device at rest for a while.
PoseValidator calm(bool touching, const PoseLimits& limits = {}) {
    PoseValidator validator(limits);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(validator.take(at(0), kTick, touching), PoseFault::None);
    return validator;
}

/// Number of ticks of `next(tick)` until the fault is found; 1: in the same tick.
template <class Next>
int ticksUntil(PoseFault fault, PoseValidator validator, const Next& next, bool touching = true) {
    for (int tick = 1; tick <= 1000; ++tick) {
        const PoseFault found = validator.take(next(tick), kTick, touching);
        if (found == fault) return tick;
        EXPECT_EQ(found, PoseFault::None);
    }
    return 0;
}

TEST(PoseValidator, ANumberThatIsNotFiniteIsAFaultInItsTick) {
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
        for (int axis = 0; axis < 7; ++axis) {
            PoseValidator validator = calm(false);
            PoseReading reading = at(0);
            (axis < 3 ? reading.position[axis] : reading.rotation.coeffs()[axis - 3]) = bad;
            EXPECT_EQ(validator.take(reading, kTick, false), PoseFault::NotANumber);
        }
    }
}

TEST(PoseValidator, AQuaternionThatIsNotUnitIsAFaultInItsTick) {
    for (const double length : {0.0, 1e-300, 0.5, 0.9, 0.99, 1.01, 1.1, 2.0, 1e200}) {
        PoseValidator validator = calm(false);
        PoseReading reading = at(0);
        reading.rotation.coeffs() *= length;
        EXPECT_EQ(validator.take(reading, kTick, false), PoseFault::InvalidRotation) << length;
    }
    PoseValidator validator = calm(false);
    PoseReading rounded = at(0);
    rounded.rotation.coeffs() *= 1 + 1e-4;
    EXPECT_EQ(validator.take(rounded, kTick, false), PoseFault::None);
}

TEST(PoseValidator, AQuaternionAndItsNegativeAreTheSameRotation) {
    std::mt19937 random(20261125);
    std::normal_distribution<double> some;
    for (int i = 0; i < 200; ++i) {
        const Quat turn = Quat(some(random), some(random), some(random), some(random)).normalized();
        PoseValidator validator;
        for (int tick = 0; tick < 20; ++tick) {
            PoseReading reading = at(Vec3::Zero(), turn);
            if (random() % 2 == 0) reading.rotation.coeffs() *= -1;
            ASSERT_EQ(validator.take(reading, kTick, true), PoseFault::None);
        }
    }
}

TEST(PoseValidator, ARotationFasterThanAWristIsAFaultInItsTick) {
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0.6, 0, -0.8)}) {
        for (const double speed : {31.0, 50.0, 500.0, 1000 * std::numbers::pi}) {
            const auto next = [&](int tick) { return at(Vec3::Zero(), turned(speed * kTick * tick, axis)); };
            EXPECT_EQ(ticksUntil(PoseFault::RotatesTooFast, calm(false), next, false), 1) << speed;
        }
    }
    PoseValidator validator = calm(false);
    for (int tick = 1; tick < 1000; ++tick)
        ASSERT_EQ(validator.take(leaning(0.029 * tick), kTick, true), PoseFault::None);
}

TEST(PoseValidator, AnAlternatingRotationIsAFault) {
    for (const double angle : {0.05, 0.6, 1.5, 3.1}) {
        const auto next = [&](int tick) { return leaning(tick % 2 == 0 ? 0 : angle); };
        EXPECT_EQ(ticksUntil(PoseFault::RotatesTooFast, calm(false), next, false), 1) << angle;
    }
}

TEST(PoseValidator, ARotationThatIsReadLessOftenGetsItsTime) {
    PoseLimits limits;
    limits.rotationPeriod = 0.02;
    PoseValidator validator = calm(true, limits);
    for (int tick = 1; tick < 1000; ++tick) {  // 10 rad/s, seen every 20 ms
        ASSERT_EQ(validator.take(leaning(0.01 * (tick - tick % 20)), kTick, true), PoseFault::None) << tick;
    }
    PoseValidator rested = calm(true, limits);
    for (int tick = 0; tick < 5000; ++tick) (void)rested.take(leaning(0), kTick, true);
    EXPECT_EQ(rested.take(leaning(0.7), kTick, true), PoseFault::RotatesTooFast) << "a rest of 5 s is no time to turn";
}

TEST(PoseValidator, AJumpIsAFaultInItsTickAndASmallerOneInContact) {
    for (const double jump : {10.1, 50.0, 1e5, 1e7, 1e300}) {
        EXPECT_EQ(ticksUntil(
                      PoseFault::Jump, calm(false), [&](int) { return at(jump); }, false),
                  1)
            << jump;
    }
    for (const double jump : {2.01, 3.0, 4.9, 9.0}) {
        PoseValidator free = calm(false);
        EXPECT_EQ(free.take(at(jump), kTick, false), PoseFault::None) << jump;
        EXPECT_EQ(ticksUntil(PoseFault::Jump, calm(true), [&](int) { return at(jump); }), 1) << jump;
        PoseValidator arrives = calm(false);
        EXPECT_EQ(arrives.take(at(jump), kTick, true), PoseFault::Jump) << "it comes to touch by the jump";
        PoseValidator leaves = calm(true);
        EXPECT_EQ(leaves.take(at(jump), kTick, false), PoseFault::Jump) << "it comes off by the jump";
    }
}

TEST(PoseValidator, AJumpAfterARestIsAFault) {
    PoseValidator validator = calm(true);
    for (int tick = 0; tick < 5000; ++tick) (void)validator.take(at(0), kTick, true);
    EXPECT_EQ(validator.take(at(2.1), kTick, true), PoseFault::Jump);
}

TEST(PoseValidator, LastingJitterIsALastingFault) {
    for (const double size : {1.6, 2.5, 4.9, 20.0}) {
        PoseValidator validator = calm(true);
        for (int tick = 1; tick < 2000; ++tick) {
            const bool touches = tick % 2 == 0;  // only one of the two positions is in the tooth
            ASSERT_NE(validator.take(at(tick % 2 == 0 ? 0 : size), kTick, touches), PoseFault::None) << tick;
        }
        for (int tick = 1; tick < kFaultHoldTicks - 1; ++tick)
            ASSERT_NE(validator.take(at(0), kTick, false), PoseFault::None);
        (void)validator.take(at(0), kTick, false);
        EXPECT_EQ(validator.take(at(0), kTick, false), PoseFault::None) << "and then the device is believed again";
    }
}

TEST(PoseValidator, DriftFasterThanAHandAtTheToothIsAFaultWithinTwoTicks) {
    for (const double rate : {500.0, 1000.0, 2000.0, 4000.0}) {
        for (const double speed : {1600.0, 3000.0, 4900.0}) {  // mm/s
            PoseValidator validator;
            for (int i = 0; i < 10; ++i) (void)validator.take(at(0), 1 / rate, true);
            double found = 0;
            for (int tick = 1; tick < 100 && found == 0; ++tick) {
                if (validator.take(at(speed / rate * tick), 1 / rate, true) != PoseFault::None) found = tick / rate;
            }
            EXPECT_GT(found, 0) << rate << ' ' << speed;
            EXPECT_LE(found, 0.002) << rate << ' ' << speed;
        }
    }
}

TEST(PoseValidator, AFastHandIsNotAFault) {
    PoseValidator free = calm(false);
    for (int tick = 1; tick < 1000; ++tick) ASSERT_EQ(free.take(at(4.0 * tick), kTick, false), PoseFault::None);
    PoseValidator touching = calm(true);
    for (int tick = 1; tick < 1000; ++tick) ASSERT_EQ(touching.take(at(1.4 * tick), kTick, true), PoseFault::None);
}

/// A hand that slides at 0.5 m/s, with an uneven clock.
TEST(PoseValidator, AnUnevenClockMakesNoFault) {
    std::mt19937 random(20261125);
    std::uniform_real_distribution<double> wait(0.0001, 0.0028);
    PoseValidator validator = calm(true);
    double time = 0;
    for (int tick = 1; tick < 20000; ++tick) {
        const double elapsed = wait(random);
        time += elapsed;
        ASSERT_EQ(validator.take(at(500 * time), elapsed, true), PoseFault::None) << tick;
    }
}

/// Readings come every millisecond; a tick sees two of them, or none.
TEST(PoseValidator, TheTimeOfTheMeasurementCounts) {
    PoseValidator validator;
    for (int tick = 1; tick < 5000; ++tick) {
        const double now = kTick * tick;
        const int reading = tick - tick % 3;  // every third tick; it is up to 2 ms old
        const bool isFresh = tick % 3 == 0;
        const double age = now - kTick * reading + 0.0002;
        ASSERT_EQ(validator.take({Vec3(0.5 * reading, 0, 0), Quat::Identity(), age, isFresh}, kTick, true),
                  PoseFault::None)
            << tick;
    }
}

TEST(PoseValidator, AnOldReadingIsAFault) {
    for (const double age : {0.0051, 0.02, 1.0, 1e9, kInfinity, kNan, -0.5, -kInfinity}) {
        PoseValidator validator = calm(false);
        PoseReading reading = at(0);
        reading.age = age;
        EXPECT_EQ(validator.take(reading, kTick, false), PoseFault::Stale) << age;
        reading.age = 0.004;
        for (int tick = 0; tick < kFaultHoldTicks; ++tick) (void)validator.take(reading, kTick, false);
        EXPECT_EQ(validator.take(reading, kTick, false), PoseFault::None);
    }
}

TEST(PoseValidator, CheckGivesTheResultOfTakeAndChangesNothing) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> part(-1, 1);
    PoseValidator validator;
    double place = 0;
    for (int tick = 0; tick < 20000; ++tick) {
        place += random() % 500 == 0 ? 5 * part(random) : 0.3 * part(random);
        PoseReading reading = at(Vec3(place, 0, 0), turned(0.02 * part(random)));
        if (random() % 1000 == 0) reading.rotation.coeffs() *= 1.5;
        const bool touching = random() % 2 == 0;
        const PoseFault expected = validator.check(reading, kTick, touching);
        ASSERT_EQ(validator.check(reading, kTick, touching), expected);
        ASSERT_EQ(validator.take(reading, kTick, touching), expected) << tick;
    }
}

TEST(PoseValidator, WithoutLimitsOnlyNaNIsAFault) {
    PoseValidator validator(PoseLimits::unlimited());
    (void)validator.take(at(0), kTick, true);
    PoseReading far = at(Vec3(1e5, 0, 0), turned(3));
    far.age = 100;
    EXPECT_EQ(validator.take(far, kTick, true), PoseFault::None);
    far.position.x() = kNan;
    EXPECT_EQ(validator.take(far, kTick, true), PoseFault::NotANumber);
}

TEST(PoseValidator, AJumpWithAnAgeThatIsNotFiniteIsNotFollowed) {
    PoseValidator validator = calm(false);
    PoseReading bad = at(1e9);
    bad.age = kNan;
    EXPECT_EQ(validator.take(bad, kTick, false), PoseFault::Jump);
    for (int tick = 1; tick < 500; ++tick) (void)validator.take(at(0.25 * tick), kTick, false);
    EXPECT_NEAR(validator.speed(), 250, 1e-6);
}

TEST(PoseValidator, TheSpeedIsThatOfTheHand) {
    PoseValidator validator = calm(true);
    for (int tick = 1; tick < 50; ++tick) (void)validator.take(at(0.25 * tick), kTick, true);
    EXPECT_NEAR(validator.speed(), 250, 1e-6);
}

TEST(PoseValidator, AFaultyClockDoesNotEndAFault) {
    for (const double elapsed : {kNan, kInfinity, -1.0}) {
        PoseValidator validator = calm(true);
        (void)validator.take(at(50), kTick, true);
        EXPECT_NE(validator.take(at(50), elapsed, true), PoseFault::None);
        EXPECT_NE(validator.take(at(50), kTick, true), PoseFault::None);
    }
}

}  // namespace
}  // namespace tactooth
