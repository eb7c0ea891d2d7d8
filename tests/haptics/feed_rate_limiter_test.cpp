// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/feed_rate_limiter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/servo_tick.h"

namespace tactooth {
namespace {

using test::kTick;

Pose at(const Vec3& position) { return {position, Quat::Identity()}; }

TEST(FeedRateLimiter, MovesAtTheRateOfTheCut) {
    FeedRateLimiter limiter;
    for (int i = 0; i < 10; ++i) limiter.pass(kTick);
    limiter.allow(0.1);
    const Pose goal = limiter.goal(at(Vec3(0, 0, -0.4)), at(Vec3::Zero()), Vec3::Zero(), kTick);
    EXPECT_NEAR(goal.position.z(), -0.011, 1e-12);  // a tenth of the distance, and a little more
    EXPECT_EQ(goal.position.head<2>().norm(), 0);
}

TEST(FeedRateLimiter, NeverGoesBeyondTheDevice) {
    FeedRateLimiter limiter;
    limiter.pass(kTick);
    limiter.allow(1);
    const Pose device = at(Vec3(0, 0, -0.003));
    EXPECT_EQ(limiter.goal(device, at(Vec3::Zero()), Vec3::Zero(), kTick).position, device.position);
    EXPECT_EQ(limiter.goal(device, device, Vec3::Zero(), kTick).position, device.position);
}

TEST(FeedRateLimiter, FollowsTheDeviceAcrossAndRotatesWithIt) {
    const FeedRateLimiter limiter;
    const Pose device{Vec3(0.02, 0, -0.4), Quat(Eigen::AngleAxisd(0.1, Vec3::UnitX()))};
    const Pose goal = limiter.goal(device, at(Vec3(0.015, 0, 0)), Vec3(0.005, 0, 0), kTick);
    EXPECT_NEAR(goal.position.x(), 0.02, 1e-12);
    EXPECT_EQ(goal.rotation.coeffs(), device.rotation.coeffs());
}

TEST(FeedRateLimiter, AimsAtThePositionOfTheDeviceBeforeTheTick) {
    const FeedRateLimiter limiter;
    const Vec3 bur(0.01, 0, 0);
    const Vec3 before(0.04, 0, -0.4);
    const Vec3 step(0.001, 0, 0);
    const Vec3 displacement = limiter.goal(at(before + step), at(bur), step, kTick).position - bur - step;
    const Vec3 inward = (before - bur).normalized();
    EXPECT_LT((displacement - displacement.dot(inward) * inward).norm(), 1e-12);
}

TEST(FeedRateLimiter, AddsTheDistanceThatALateTickHasLeft) {
    FeedRateLimiter limiter;
    for (int i = 0; i < 5; ++i) limiter.pass(kTick);
    limiter.allow(0.05);
    const auto step = [&] {
        return -limiter.goal(at(Vec3(0, 0, -0.4)), at(Vec3::Zero()), Vec3::Zero(), kTick).position.z();
    };
    limiter.carryOver(0.004);
    EXPECT_NEAR(step(), 0.011 + 0.004, 1e-12);
    limiter.carryOver(0.3);  // no jump to the device
    EXPECT_NEAR(step(), 0.011 + 0.01, 1e-12);
    limiter.carryOver(0);
    EXPECT_NEAR(step(), 0.011, 1e-12);
}

TEST(FeedRateLimiter, IsNotSlowerThanTheDevice) {
    const FeedRateLimiter limiter;
    const Pose goal = limiter.goal(at(Vec3(0, 0, -0.4)), at(Vec3::Zero()), Vec3(0, 0, -0.01), kTick);
    EXPECT_NEAR(goal.position.z(), -0.01, 1e-12);
}

TEST(FeedRateLimiter, CatchesUpWhereItLagsByMillimetres) {
    const FeedRateLimiter limiter;
    double z = 0;
    double last = 0;
    for (int tick = 0; tick < 150; ++tick) {
        const double next = limiter.goal(at(Vec3(0, 0, -3.5)), at(Vec3(0, 0, z)), Vec3::Zero(), kTick).position.z();
        if (tick == 0) last = next - z;
        EXPECT_LE(std::abs(next - z), std::abs(last) + 1e-12) << "the first step is the longest";
        last = next - z;
        z = next;
    }
    EXPECT_NEAR(last, -0.003, 1e-3);
    EXPECT_LT(z, -2.8);  // all but a twentieth of the 3 mm beyond the usual lag, and half of a millimetre
}

TEST(FeedRateLimiter, ALongPauseStartsANewCut) {
    FeedRateLimiter limiter;
    limiter.pass(60);
    limiter.allow(0.03);
    EXPECT_NEAR(limiter.goal(at(Vec3(0, 0, -0.4)), at(Vec3::Zero()), Vec3::Zero(), kTick).position.z(), -0.002, 1e-12);
    limiter.pass(kTick);
    limiter.allow(0.003);
    EXPECT_NEAR(limiter.goal(at(Vec3(0, 0, -0.4)), at(Vec3::Zero()), Vec3::Zero(), kTick).position.z(), -0.0033, 1e-12);
}

}  // namespace
}  // namespace tactooth
