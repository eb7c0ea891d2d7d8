// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/safety_limiter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "adversary.h"
#include "support/servo_tick.h"

namespace tactooth {
namespace {

using test::kTick;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kNan = std::nan("");

// Only the limiter makes one: no other code can, from a wrench, from its parts, or by changing an existing one.
static_assert(!std::is_constructible_v<SafeWrench, Wrench>);
static_assert(!std::is_constructible_v<SafeWrench, Vec3, Vec3>);
static_assert(!std::is_convertible_v<Wrench, SafeWrench>);
static_assert(!std::is_assignable_v<SafeWrench&, Wrench>);
static_assert(std::is_const_v<std::remove_reference_t<decltype(std::declval<SafeWrench&>().force())>>);
static_assert(std::is_const_v<std::remove_reference_t<decltype(std::declval<SafeWrench&>().torque())>>);

ForceLimits limits() {
    ForceLimits result;
    result.torque = 50;
    return result;
}

Wrench push(double newton) { return {Vec3(0, 0, newton), Vec3::Zero()}; }

/// A limiter that has been enabled for a second.
SafetyLimiter warmLimiter() {
    SafetyLimiter limiter(limits());
    for (int i = 0; i < 1000; ++i) (void)limiter.limit({}, kTick, true, 0);
    return limiter;
}

double settledForce(SafetyLimiter& limiter, double wanted) {
    double force = 0;
    for (int i = 0; i < 100; ++i) force = limiter.limit(push(wanted), kTick, true, 0).force().z();
    return force;
}

TEST(SafetyLimiter, ASafeWrenchBeginsAsZero) {
    EXPECT_EQ(SafeWrench().force(), Vec3::Zero());
    EXPECT_EQ(SafeWrench().torque(), Vec3::Zero());
}

TEST(SafetyLimiter, PassesAForceWithinTheLimits) {
    SafetyLimiter limiter = warmLimiter();
    EXPECT_DOUBLE_EQ(settledForce(limiter, 2.5), 2.5);
    EXPECT_EQ(limiter.faults(), 0U);
}

TEST(SafetyLimiter, ShortensALargeForceAndKeepsItsDirection) {
    SafetyLimiter limiter = warmLimiter();
    const Vec3 wanted(3, -4, 2);
    SafeWrench result;
    for (int i = 0; i < 100; ++i) result = limiter.limit({wanted, Vec3::Zero()}, kTick, true, 0);
    EXPECT_TRUE(result.force().isApprox(3.3 * wanted.normalized(), 1e-12));
}

TEST(SafetyLimiter, AForceNearTheLargestDoubleIsStillShortened) {
    SafetyLimiter limiter = warmLimiter();
    constexpr double kHuge = std::numeric_limits<double>::max();
    SafeWrench result;
    for (int i = 0; i < 100; ++i) result = limiter.limit({Vec3(kHuge, -kHuge, 0), Vec3::Zero()}, kTick, true, 0);
    EXPECT_TRUE(result.force().isApprox(3.3 * Vec3(1, -1, 0).normalized(), 1e-12));
}

TEST(SafetyLimiter, ADeviceWithoutTorqueGetsNone) {
    SafetyLimiter limiter{ForceLimits{}};
    for (int i = 0; i < 600; ++i) {
        EXPECT_EQ(limiter.limit({Vec3::Zero(), Vec3(1e6, 2, 3)}, kTick, true, 0).torque(), Vec3::Zero());
    }
}

TEST(SafetyLimiter, RampsUpAfterSwitchingOn) {
    SafetyLimiter limiter(limits());
    for (int i = 1; i <= 1000; ++i) {
        const double force = limiter.limit(push(2), kTick, true, 0).force().z();
        ASSERT_NEAR(force, 2 * std::min(1.0, i * kTick / 0.5), 1e-9) << i;
    }
    EXPECT_EQ(limiter.limit(push(2), kTick, false, 0).force(), Vec3::Zero());
    EXPECT_NEAR(limiter.limit(push(2), kTick, true, 0).force().z(), 2 * kTick / 0.5, 1e-12);
    EXPECT_EQ(limiter.faults(), 0U);
}

TEST(SafetyLimiter, AStepTakesAsLongAsTheSlewRateAllows) {
    SafetyLimiter limiter = warmLimiter();
    for (int i = 1; i <= 10; ++i) {
        ASSERT_NEAR(limiter.limit(push(3), kTick, true, 0).force().z(), std::min(3.0, 0.3 * i), 1e-9);
    }
    for (int i = 1; i <= 10; ++i) {
        const Wrench wanted{Vec3(0, 0, 3), Vec3(30, 0, 0)};
        ASSERT_NEAR(limiter.limit(wanted, kTick, true, 0).torque().x(), std::min(30.0, 3.0 * i), 1e-9);
    }
}

TEST(SafetyLimiter, NotANumberGivesZeroAndStartsTheRampAnew) {
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
        for (int component = 0; component < 6; ++component) {
            SafetyLimiter limiter = warmLimiter();
            settledForce(limiter, 3);
            Wrench wrench = push(3);
            (component < 3 ? wrench.force[component] : wrench.torque[component - 3]) = bad;
            const SafeWrench result = limiter.limit(wrench, kTick, true, 0);
            EXPECT_EQ(result.force(), Vec3::Zero());
            EXPECT_EQ(result.torque(), Vec3::Zero());
            EXPECT_EQ(limiter.faults(), 1U);
            EXPECT_NEAR(limiter.limit(push(3), kTick, true, 0).force().z(), 3 * kTick / 0.5, 1e-12);
        }
    }
}

TEST(SafetyLimiter, ALateTickOrAnInvalidTimeGivesZero) {
    for (const double elapsed : {0.0031, 1.0, -0.001, kNan, kInfinity}) {
        SafetyLimiter limiter = warmLimiter();
        settledForce(limiter, 3);
        EXPECT_EQ(limiter.limit(push(3), elapsed, true, 0).force(), Vec3::Zero()) << elapsed;
        EXPECT_EQ(limiter.faults(), 1U);
    }
    SafetyLimiter limiter = warmLimiter();
    settledForce(limiter, 3);
    EXPECT_DOUBLE_EQ(limiter.limit(push(3), 0.003, true, 0).force().z(), 3);
}

TEST(SafetyLimiter, AMillionHostileWrenchesStayWithinMagnitudeAndSlewRate) {
    const ForceLimits allowed = limits();
    SafetyLimiter limiter(allowed);
    test::Adversary adversary(20260203);
    const auto erraticTime = [&] {
        if (adversary.oneIn(16)) return adversary.oddTime();
        return adversary.oneIn(16) ? 0.004 * std::abs(adversary.part()) : kTick;
    };
    SafeWrench last;
    long strong = 0;
    long zero = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        const Wrench wanted = i % 64 < 40 ? push(10) : Wrench{adversary.vector(), adversary.vector()};
        const double elapsed = i % 64 < 40 ? kTick : erraticTime();
        const bool enabled = !adversary.oneIn(500);
        const SafeWrench got = limiter.limit(wanted, elapsed, enabled, 0);
        const bool allowedToPush = wanted.force.allFinite() && wanted.torque.allFinite() && elapsed >= 0 &&
                                   elapsed <= allowed.tickTimeout && enabled;
        if (allowedToPush) {
            ASSERT_LE(got.force().norm(), allowed.force * (1 + 1e-12));
            ASSERT_LE(got.torque().norm(), allowed.torque * (1 + 1e-12));
            ASSERT_LE((got.force() - last.force()).norm(), allowed.slew * elapsed + 1e-12);
            ASSERT_LE((got.torque() - last.torque()).norm(), allowed.torqueSlew * elapsed + 1e-11);
        } else {
            ASSERT_TRUE(got.force().isZero(0) && got.torque().isZero(0));
            ++zero;
        }
        strong += got.force().norm() > 0.2;
        last = got;
    }
    EXPECT_GT(strong, 50'000);  // the sample means something
    EXPECT_GT(zero, 50'000);
}

TEST(SafetyLimiter, WithoutARampOnlyTheSlewRateDelaysTheForce) {
    ForceLimits allowed = limits();
    allowed.rampTime = 0;
    SafetyLimiter limiter(allowed);
    EXPECT_NEAR(limiter.limit(push(0.2), kTick, true, 0).force().z(), 0.2, 1e-12);
}

TEST(SafetyLimiter, ForceTimesSpeedStaysWithinThePower) {
    for (const double speed : {1e-300, 1.0, 100.0, 690.0, 710.0, 1500.0, 1e5, 1e300}) {
        SafetyLimiter limiter = warmLimiter();
        settledForce(limiter, 3.3);
        const double force = limiter.limit(push(3.3), kTick, true, speed).force().norm();
        EXPECT_LE(force * speed, limiter.limits().power * (1 + 1e-12)) << speed;
        EXPECT_NEAR(force, std::min(3.3, limiter.limits().power / speed), 1e-9) << speed;
        EXPECT_EQ(limiter.faults(), 0U);
    }
}

TEST(SafetyLimiter, AnInvalidSpeedGivesZero) {
    for (const double speed : {kNan, kInfinity, -kInfinity, -1.0}) {
        SafetyLimiter limiter = warmLimiter();
        settledForce(limiter, 3);
        EXPECT_EQ(limiter.limit(push(3), kTick, true, speed).force(), Vec3::Zero()) << speed;
        EXPECT_EQ(limiter.faults(), 1U);
    }
}

TEST(SafetyLimiter, FadesALastForceToAnyShareAndStartsFromZeroAgain) {
    SafetyLimiter limiter = warmLimiter();
    SafeWrench pressed;
    for (int i = 0; i < 100; ++i) pressed = limiter.limit(push(3), kTick, true, 0);
    ASSERT_DOUBLE_EQ(pressed.force().z(), 3);
    EXPECT_DOUBLE_EQ(limiter.fade(pressed, 0.5).force().z(), 1.5);
    EXPECT_EQ(limiter.strength(), 0);
    EXPECT_DOUBLE_EQ(limiter.fade(pressed, 2).force().z(), 3) << "never more than it was";
    for (const double nothing : {0.0, -1.0, kNan}) {
        EXPECT_EQ(limiter.fade(pressed, nothing).force(), Vec3::Zero()) << nothing;
    }
    const double next = limiter.limit(push(3), kTick, true, 0).force().z();
    EXPECT_LE(next, 3 * kTick / limits().rampTime + 1e-12) << "the ramp starts anew";
    EXPECT_EQ(limiter.faults(), 0U);
}

}  // namespace
}  // namespace tactooth
