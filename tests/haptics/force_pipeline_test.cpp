// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/force_pipeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "adversary.h"
#include "support/servo_tick.h"

namespace tactooth {
namespace {

using test::kTick;
constexpr double kStep = 0.3;  // N: the largest change of a force in a tick
constexpr double kRounding = 1e-9;
const double kNan = std::nan("");

ForceLimits touchLimits() {
    ForceLimits limits;
    limits.continuousForce = 0.88;
    return limits;
}

ForceCommand inAir() { return {}; }

/// A hand at rest with the force of a spring of 1 N/mm.
ForceCommand pushed(const Vec3& force) {
    ForceCommand wanted;
    wanted.wrench.force = force;
    wanted.deflection = force.norm();
    wanted.stiffness = 1;
    wanted.touching = true;
    return wanted;
}

ForceCommand pushed(double newton) { return pushed(Vec3(0, 0, newton)); }

/// A pipeline that has been enabled in free space for a second: at full strength.
ForcePipeline ready(const ForceLimits& limits = touchLimits()) {
    ForcePipeline pipeline(limits);
    for (int i = 0; i < 1000; ++i) (void)pipeline.pass(inAir(), kTick);
    return pipeline;
}

double settled(ForcePipeline& pipeline, const ForceCommand& wanted, int ticks = 50) {
    double force = 0;
    for (int i = 0; i < ticks; ++i) force = pipeline.pass(wanted, kTick).force().norm();
    return force;
}

TEST(ForcePipeline, AHandAtRestGetsTheWholeForce) {
    ForcePipeline pipeline = ready();
    EXPECT_NEAR(settled(pipeline, pushed(1.2)), 1.2, kRounding);
    EXPECT_EQ(pipeline.state(), ForceState::On);
    EXPECT_EQ(pipeline.faults(), 0U);
}

TEST(ForcePipeline, AStartInsideTheToothGivesZeroUntilTheToolWasInFreeSpace) {
    ForcePipeline pipeline(touchLimits());
    EXPECT_EQ(settled(pipeline, pushed(2), 3000), 0);
    EXPECT_EQ(pipeline.state(), ForceState::AwaitsFreeSpace);
    (void)pipeline.pass(inAir(), kTick);
    EXPECT_NEAR(settled(pipeline, pushed(2)), 2, kRounding);
    EXPECT_EQ(pipeline.state(), ForceState::On);
}

TEST(ForcePipeline, SwitchingOffFadesOutAndSwitchingOnWaitsForFreeSpace) {
    ForcePipeline pipeline = ready();
    double last = settled(pipeline, pushed(2));
    ForceCommand off = pushed(2);
    off.allowed = false;
    int ticks = 0;
    while (last > 0) {
        const double force = pipeline.pass(off, kTick).force().norm();
        ASSERT_LE(last - force, kStep + kRounding);
        last = force;
        ASSERT_LT(++ticks, 10);
    }
    EXPECT_EQ(settled(pipeline, off, 10), 0);
    EXPECT_EQ(pipeline.state(), ForceState::Off);
    EXPECT_EQ(settled(pipeline, pushed(2), 1000), 0);
    EXPECT_EQ(settled(pipeline, inAir(), 1), 0);
    for (int i = 0; i < 1000; ++i) {
        const double force = pipeline.pass(pushed(2), kTick).force().norm();
        ASSERT_LE(force - last, kStep + kRounding);
        last = force;
    }
    EXPECT_NEAR(last, 2, kRounding);
}

TEST(ForcePipeline, ALostDeviceOrAFaultyInputGivesZeroInTheSameTick) {
    std::vector<ForceCommand> broken(13, pushed(2));
    broken[0].connected = false;
    broken[1].hand.y() = kNan;
    broken[2].wrench.force.x() = kNan;
    broken[3].deflection = kNan;
    broken[4].stiffness = std::numeric_limits<double>::infinity();
    broken[5].stiffness = -1;
    broken[6].deflection = -std::numeric_limits<double>::infinity();
    broken[7].motorTemperature = kNan;
    broken[8].driveForce.z() = kNan;
    broken[9].turn.coeffs() *= 1.1;
    broken[10].turn.w() = kNan;
    broken[11].turn = Quat(Eigen::AngleAxisd(0.5, Vec3::UnitX()));
    broken[12].age = 0.006;
    for (const ForceCommand& wanted : broken) {
        ForcePipeline pipeline = ready();
        settled(pipeline, pushed(2));
        EXPECT_EQ(pipeline.pass(wanted, kTick).force(), Vec3::Zero());
        EXPECT_EQ(pipeline.state(), ForceState::Fault);
        EXPECT_EQ(pipeline.faults(), 1U);
        EXPECT_EQ(pipeline.fault() == PoseFault::None, !wanted.connected)
            << "what is wrong with a device it says itself";
        EXPECT_EQ(settled(pipeline, pushed(2), 1000), 0) << "waits until the tool was free";
        (void)pipeline.pass(inAir(), kTick);
        EXPECT_GT(settled(pipeline, pushed(2), 600), 1.9);
    }
}

TEST(ForcePipeline, AJumpIsAFault) {
    for (const double jump : {12.0, 50.0, 1e300, std::numeric_limits<double>::infinity()}) {
        ForcePipeline pipeline = ready();
        settled(pipeline, pushed(2));
        ForceCommand wanted = pushed(2);
        wanted.hand = Vec3(0, jump, 0);
        EXPECT_EQ(pipeline.pass(wanted, kTick).force(), Vec3::Zero()) << jump;
        EXPECT_EQ(pipeline.state(), ForceState::Fault);
        EXPECT_EQ(settled(pipeline, wanted, 100), 0);
    }
}

TEST(ForcePipeline, AFastHandGetsNoMoreThanThePowerLimit) {
    ForcePipeline pipeline = ready();
    ForceCommand wanted = pushed(3.3);
    wanted.driveForce = wanted.wrench.force;  // which the passivity controller does not damp
    for (int i = 0; i < 200; ++i) {
        wanted.hand.x() += 0.005 * i;  // up to 1 m/s
        const double force = pipeline.pass(wanted, kTick).force().norm();
        const double speed = 5.0 * i;  // mm/s
        ASSERT_LE(force * speed, touchLimits().power * (1 + 1e-9)) << i;
        ASSERT_EQ(pipeline.faults(), 0U);
    }
}

TEST(ForcePipeline, AfterAFaultTheForceComesBackWithTheRamp) {
    ForcePipeline pipeline = ready();
    settled(pipeline, pushed(2));
    ForceCommand aside = pushed(2);
    aside.hand.x() = 4.9;
    (void)pipeline.pass(aside, kTick);
    EXPECT_EQ(pipeline.fault(), PoseFault::Jump);
    aside.touching = false;
    aside.wrench.force.setZero();
    EXPECT_EQ(settled(pipeline, aside, 99), 0);
    EXPECT_EQ(pipeline.state(), ForceState::Fault) << "a tenth of a second is not over yet";
    EXPECT_EQ(settled(pipeline, aside, 5), 0);
    EXPECT_NE(pipeline.state(), ForceState::Fault);
    aside = pushed(2);
    aside.hand.x() = 4.9;
    double last = 0;
    for (int i = 0; i < 600; ++i) {
        const double force = pipeline.pass(aside, kTick).force().norm();
        ASSERT_LE(force - last, (i == 0 ? 6 : 1) * 2 * kTick / 0.5 + kRounding) << "the ramp began in the air";
        last = force;
    }
    EXPECT_NEAR(last, 2, kRounding);
}

TEST(ForcePipeline, TheFastestHandIsNotAFault) {
    ForcePipeline pipeline = ready();
    ForceCommand wanted = inAir();
    for (int i = 0; i < 100; ++i) {
        wanted.hand.x() += 2.0;  // 2 m/s
        (void)pipeline.pass(wanted, kTick);
    }
    EXPECT_EQ(pipeline.faults(), 0U);
}

TEST(ForcePipeline, AStalledLoopGivesZeroAndThenTheRamp) {
    ForcePipeline pipeline = ready();
    settled(pipeline, pushed(2));
    EXPECT_EQ(pipeline.pass(pushed(2), 0.005).force(), Vec3::Zero());
    EXPECT_NEAR(pipeline.pass(pushed(2), kTick).force().norm(), 2 * kTick / 0.5, kRounding);
    EXPECT_GT(settled(pipeline, pushed(2), 600), 1.9);
    EXPECT_EQ(pipeline.pass(pushed(2), 0.3).force(), Vec3::Zero());
    EXPECT_EQ(settled(pipeline, pushed(2), 600), 0) << "after a long pause the hand may be anywhere";
}

TEST(ForcePipeline, AForceTurnsByARightAngleInTenTicks) {
    ForcePipeline pipeline = ready();
    settled(pipeline, pushed(Vec3(0, 0, 1)));
    Vec3 last(0, 0, 1);
    int ticks = 0;
    while (last.normalized().x() < 0.99) {
        const Vec3 force = pipeline.pass(pushed(Vec3(1, 0, 0)), kTick).force();
        const Vec3 along = last.normalized();
        const Vec3 change = force - last;
        ASSERT_LE((change - change.dot(along) * along).norm(), 0.15 + kRounding);
        last = force;
        ASSERT_LT(++ticks, 20);
    }
    EXPECT_GE(ticks, 5);
}

TEST(ForcePipeline, ALongPressFallsToTheContinuousForce) {
    ForcePipeline pipeline = ready();
    EXPECT_NEAR(settled(pipeline, pushed(3.3), 2000), 3.3, kRounding);
    EXPECT_NEAR(settled(pipeline, pushed(3.3), 120'000), 0.88, 0.05);
    EXPECT_EQ(pipeline.state(), ForceState::Warm);
    EXPECT_NEAR(settled(pipeline, pushed(0.5), 1000), 0.5, kRounding);
    EXPECT_EQ(pipeline.state(), ForceState::On);
}

TEST(ForcePipeline, MotorsThatReportHeatGetTheContinuousForceOnly) {
    ForcePipeline pipeline = ready();
    ForceCommand hot = pushed(3);
    hot.motorTemperature = 1;
    EXPECT_NEAR(settled(pipeline, hot), 0.88, kRounding);
    EXPECT_EQ(pipeline.state(), ForceState::Warm);
}

TEST(ForcePipeline, DampingNeverReversesTheForce) {
    ForcePipeline pipeline = ready();
    double z = 0;
    for (int i = 0; i < 2000; ++i) {
        z = -0.2 + 0.2 * std::cos(0.9 * i);  // much faster than a hand: the spring leaks at every tick
        ForceCommand wanted = pushed(-z);
        wanted.hand = Vec3(0, 0, z);
        ASSERT_GE(pipeline.pass(wanted, kTick).force().z(), -kRounding);
    }
}

TEST(ForcePipeline, EqualCallsGiveEqualBits) {
    ForcePipeline first = ready();
    ForcePipeline second = ready();
    std::mt19937 random(20261121);
    std::normal_distribution<double> some;
    Vec3 hand = Vec3::Zero();
    for (int i = 0; i < 20'000; ++i) {
        hand += 0.02 * Vec3(some(random), some(random), some(random));
        ForceCommand wanted = pushed(Vec3(some(random), some(random), some(random)));
        wanted.hand = hand;
        wanted.touching = i % 300 != 0;
        ASSERT_EQ(first.pass(wanted, kTick).force(), second.pass(wanted, kTick).force());
    }
}

/// Usually a hand that moves in and out of a tooth; sometimes an input is faulty.
class ErraticDevice {
public:
    ForceCommand wanted() {
        hand_ += 0.05 * Vec3(from_.part(), from_.part(), from_.part());
        ForceCommand wanted = pushed(4 * Vec3(from_.part(), from_.part(), 1 + from_.part()));
        wanted.hand = hand_;
        wanted.touching = !from_.oneIn(50);
        wanted.allowed = !from_.oneIn(2000);
        wanted.connected = !from_.oneIn(5000);
        if (from_.oneIn(1000)) wanted.wrench = {from_.vector(), from_.vector()};
        if (from_.oneIn(5000)) wanted.hand = from_.vector();
        if (from_.oneIn(5000)) wanted.deflection = from_.number();
        if (from_.oneIn(5000)) wanted.stiffness = from_.number();
        if (from_.oneIn(2000)) wanted.motorTemperature = from_.number();
        return wanted;
    }
    double elapsed() {
        if (from_.oneIn(2000)) return from_.oddTime();
        return from_.oneIn(10) ? 0.003 * std::abs(from_.part()) : kTick;
    }

private:
    test::Adversary from_{20261121};
    Vec3 hand_ = Vec3::Zero();
};

TEST(ForcePipeline, AMillionHostileTicksStayFiniteAndWithinForceAndSlewRate) {
    const ForceLimits allowed = touchLimits();
    ForcePipeline pipeline(allowed);
    ErraticDevice adversary;
    Vec3 last = Vec3::Zero();
    long strong = 0;
    long stopped = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        const ForceCommand wanted = adversary.wanted();
        const double elapsed = adversary.elapsed();
        const Vec3 force = pipeline.pass(wanted, elapsed).force();
        ASSERT_TRUE(force.allFinite()) << i;
        ASSERT_LE(force.norm(), allowed.force * (1 + 1e-12)) << i;
        const bool zeroed = force.isZero(0);  // a fault or a late tick: the only step that may be steep
        ASSERT_TRUE(zeroed || (force - last).norm() <= allowed.slew * elapsed + 1e-12) << i;
        strong += force.norm() > 0.5;
        stopped += pipeline.state() == ForceState::Fault;
        last = force;
    }
    EXPECT_GT(strong, 100'000);  // the sample means something
    EXPECT_GT(stopped, 300);
    EXPECT_LE(pipeline.heat().heat(), 1e300);
}

}  // namespace
}  // namespace tactooth
