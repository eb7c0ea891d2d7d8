// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Wrong calls fire an assert; bad input from a device does not: it gives zero force.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "haptics/contact_force.h"
#include "haptics/cutting_force.h"
#include "haptics/dry_friction.h"
#include "haptics/feed_rate_limiter.h"
#include "haptics/force_pipeline.h"
#include "haptics/haptic_simulation.h"
#include "haptics/haptic_surface.h"
#include "haptics/overload_check.h"
#include "haptics/tool_proxy.h"
#include "scene.h"
#include "support/expect_assert.h"
#include "support/servo_tick.h"

namespace tactooth {
namespace {

using test::kTick;
const double kNan = std::nan("");

HapticSimulation simulation() { return {test::ball(), test::kBallRadius, test::block(), HapticSettings{}}; }

#if defined(TACTOOTH_ASSERTS)

TEST(Precondition, LimitsOfTheSafetyLimiterArePositiveAndFinite) {
    const auto limiterWith = [](double ForceLimits::*limit, double value) {
        ForceLimits limits;
        limits.*limit = value;
        return SafetyLimiter(limits);
    };
    for (const double bad : {-1.0, kNan}) {
        EXPECT_ASSERT(limiterWith(&ForceLimits::force, bad));
        EXPECT_ASSERT(limiterWith(&ForceLimits::torque, bad));
        EXPECT_ASSERT(limiterWith(&ForceLimits::slew, bad));
        EXPECT_ASSERT(limiterWith(&ForceLimits::rampTime, bad));
        EXPECT_ASSERT(limiterWith(&ForceLimits::tickTimeout, bad));
        EXPECT_ASSERT(limiterWith(&ForceLimits::power, bad));
    }
}

TEST(Precondition, FrictionOfADeviceIsNotNegative) {
    EXPECT_ASSERT(PassivityController(-0.1));
    EXPECT_ASSERT(PassivityController{kNan});
}

TEST(Precondition, TheForcesOfTheThermalModelArePositive) {
    EXPECT_ASSERT(MotorThermalModel(-1, 1));
    EXPECT_ASSERT(MotorThermalModel(3, 0));
    MotorThermalModel heat(3, 1);
    EXPECT_ASSERT(heat.add(1, -kTick, 0));
}

TEST(Precondition, PoseLimitsArePositive) {
    PoseLimits limits;
    limits.speed = 0;
    EXPECT_ASSERT(PoseValidator{limits});
    limits = {};
    limits.maxAge = kNan;
    EXPECT_ASSERT(PoseValidator{limits});
}

TEST(Precondition, ScaleAndOverridesOfTheContactForceAreNotNegative) {
    ContactForce force;
    EXPECT_ASSERT(force.setScale(-1));
    EXPECT_ASSERT(force.setScale(kNan));
    EXPECT_ASSERT(force.setMaxStiffness(0));
    EXPECT_ASSERT(force.setOverrides({.stiffness = -1}));
    EXPECT_ASSERT(force.setOverrides({.damping = -1}));
    EXPECT_ASSERT(force.setOverrides({.friction = -1}));
}

TEST(Precondition, TheNormalOfFrictionIsAUnitVector) {
    DryFriction friction;
    EXPECT_ASSERT((void)friction.at(Vec3::Zero(), Vec3(0, 0, 2), 1, 1, 0));
    EXPECT_ASSERT((void)friction.at(Vec3::Zero(), Vec3::UnitZ(), -1, 1, 0));
    EXPECT_ASSERT((void)friction.at(Vec3::Zero(), Vec3::UnitZ(), 1, 1, -0.1));
}

TEST(Precondition, TheAxisOfACutIsAUnitVector) {
    CuttingForce force;
    EXPECT_ASSERT((void)force.at({Vec3::UnitX(), Vec3::Zero(), 1, 1e5, 3e5}, kTick));
    EXPECT_ASSERT((void)force.at({Vec3::UnitX(), Vec3::UnitZ(), -1, 1e5, 3e5}, kTick));
    EXPECT_ASSERT((void)CuttingForce::vibrationFrequency(1e5, std::numeric_limits<double>::infinity()));
}

TEST(Precondition, TimeAndDistanceOfTheFeedAreNotNegative) {
    FeedRateLimiter feed;
    EXPECT_ASSERT(feed.pass(-kTick));
    EXPECT_ASSERT(feed.allow(-0.1));
    EXPECT_ASSERT(feed.carryOver(kNan));
    EXPECT_ASSERT((void)feed.goal({}, {}, Vec3(kNan, 0, 0), kTick));
}

TEST(Precondition, TheProxyFollowsRigidPosesOnly) {
    ToolProxy proxy(test::ball(), test::block(), ContactMode::Proxy);
    EXPECT_ASSERT((void)proxy.follow(test::at(kNan, 0, 1)));
    EXPECT_ASSERT((void)proxy.follow({Vec3(0, 0, 1), Quat(2, 0, 0, 0)}));
    EXPECT_ASSERT((void)proxy.setSurface(nullptr));
    EXPECT_ASSERT(ToolProxy(nullptr, test::block(), ContactMode::Proxy));
}

TEST(Precondition, ASimulationNeedsABurAndTimeThatPasses) {
    EXPECT_ASSERT(HapticSimulation(test::ball(), -1, test::block(), HapticSettings{}));
    HapticSimulation running = simulation();
    EXPECT_ASSERT(running.step({test::at(0, 0, 1)}, -kTick));
    EXPECT_ASSERT(running.setTickBudget(0));
}

TEST(Precondition, AHapticSurfaceIsRecycledOnce) {
    HapticSurfaceBuilder surfaces(test::ball(), test::block());
    HapticSurface* made = surfaces.make(test::block(), test::at(0, 0, 1), test::at(0, 0, 1));
    surfaces.recycle(made);
    EXPECT_ASSERT(surfaces.recycle(made));
    EXPECT_ASSERT(surfaces.recycle(nullptr));
    EXPECT_ASSERT(surfaces.watch(kNan, test::at(0, 0, 1)));
}

TEST(Precondition, ARateIsPositive) {
    EXPECT_ASSERT(ServoLoop(0, [](double) {}));
    EXPECT_ASSERT(ServoLoop(1000, nullptr));
    const auto timing = std::make_unique<ServoTiming>();
    timing->ticks = 1'000'000;
    EXPECT_ASSERT((void)isOverloaded(*timing, 0));
    EXPECT_ASSERT((void)timing->tick.quantile(1.5));
}

#endif

TEST(Precondition, BadInputOfADeviceGivesZeroForceAndFiresNothing) {
    const test::ThrowingAsserts asserts;
    for (int what = 0; what < 6; ++what) {
        ForcePipeline pipeline{ForceLimits{}};  // a fault holds for a while: each has a pipeline of its own
        for (int i = 0; i < 1000; ++i) (void)pipeline.pass({}, kTick);
        ForceCommand wanted;
        wanted.wrench.force = Vec3(0, 0, 1);
        wanted.touching = true;
        if (what == 0) wanted.wrench.force.x() = kNan;
        if (what == 1) wanted.hand.y() = std::numeric_limits<double>::infinity();
        if (what == 2) wanted.turn = Quat(kNan, 0, 0, 0);
        if (what == 3) wanted.stiffness = -1;
        if (what == 4) wanted.age = kNan;
        const double elapsed = what == 5 ? kNan : kTick;
        SafeWrench sent;
        EXPECT_NO_THROW(sent = pipeline.pass(wanted, elapsed)) << what;
        EXPECT_TRUE(sent.force().isZero(0) && sent.torque().isZero(0)) << what;
        EXPECT_EQ(pipeline.state(), ForceState::Fault) << what;
    }
}

TEST(Precondition, ADevicePoseThatIsNotRigidIsHandledBySimulation) {
    const test::ThrowingAsserts asserts;
    HapticSimulation running = simulation();
    for (const Pose& pose : {test::at(kNan, 0, 0), Pose{Vec3::Zero(), Quat(0, 0, 0, 0)}, test::at(1e300, 0, 0)}) {
        EXPECT_NO_THROW(EXPECT_FALSE(running.step({pose}, kTick).contact.placed));
    }
    EXPECT_NO_THROW((void)running.step({test::at(0, 0, 1)}, kNan));
}

}  // namespace
}  // namespace tactooth
