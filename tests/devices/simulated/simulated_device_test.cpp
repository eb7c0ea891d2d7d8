// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/simulated/simulated_device.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/servo_tick.h"

namespace tactooth {
namespace {

using test::kTick;

DeviceKeyframe moment(double time, double x) { return {time, {{Vec3(x, 0, 0), Quat::Identity()}, 0, 0, true}}; }

/// Mechanics with a known closed-form solution: no friction, no encoder steps, no damping.
DevicePreset ideal() {
    DevicePreset preset = *findDevicePreset("touch-x");
    preset.friction = preset.damping = preset.encoderStep = 0;
    return preset;
}

SafeWrench push(double newton) {
    ForceLimits limits;
    limits.rampTime = 0;
    limits.slew = 1e9;
    SafetyLimiter limiter(limits);
    return limiter.limit({Vec3(newton, 0, 0), Vec3::Zero()}, kTick, true, 0);
}

/// Rest position under a constant force.
double restUnder(const DevicePreset& device, const HandImpedance& grip, double newton) {
    SimulatedDevice hand(device, grip, {moment(0, 0)});
    for (int i = 0; i < 5000; ++i) {
        (void)hand.read(kTick);
        hand.write(push(newton));
    }
    return hand.tip().x();
}

TEST(SimulatedDevice, GivesWayToAForceAsItsSpringDoes) {
    for (const HandImpedance& grip : handImpedances()) {
        EXPECT_NEAR(restUnder(ideal(), grip, 1), 1 / grip.stiffness, 1e-6);
    }
}

TEST(SimulatedDevice, SwingsAtTheFrequencyOfItsMassesAndSpring) {
    HandImpedance grip = *findHandImpedance("nominal");
    grip.damping = 0;
    SimulatedDevice hand(ideal(), grip, {moment(0, 0), moment(0.01, 0), moment(0.01, 1), moment(9, 1)});
    int crossings = 0;
    double last = -1;
    for (int i = 0; i < 4000; ++i) {
        const double x = hand.read(kTick).hand.position.x() - 1;
        crossings += last < 0 && x >= 0;
        last = x;
    }
    const double frequency = std::sqrt(grip.stiffness / (grip.mass + ideal().inertia)) / (2 * std::numbers::pi);
    EXPECT_NEAR(crossings, 4 * frequency, 1.01);
}

TEST(SimulatedDevice, DryFrictionHoldsWhatIsWeaker) {
    DevicePreset device = ideal();
    device.friction = 0.26;
    const HandImpedance& grip = *findHandImpedance("loose");
    EXPECT_EQ(restUnder(device, grip, 0.2), 0);
    EXPECT_GT(restUnder(device, grip, 0.5), 0.1);
}

TEST(SimulatedDevice, IsReadInEncoderSteps) {
    DevicePreset device = ideal();
    device.encoderStep = 0.055;
    SimulatedDevice hand(device, *findHandImpedance("firm"), {moment(0, 0), moment(1, 3)});
    bool moved = false;
    for (int i = 0; i < 1000; ++i) {
        const double steps = hand.read(kTick).hand.position.x() / 0.055;
        ASSERT_NEAR(steps, std::round(steps), 1e-9);
        moved |= steps > 10;
    }
    EXPECT_TRUE(moved);
}

TEST(SimulatedDevice, AForceComesAsLateAsTheLinkIsSlow) {
    for (const int delay : {0, 1, 3}) {
        DevicePreset device = ideal();
        device.delayTicks = delay;
        SimulatedDevice hand(device, *findHandImpedance("nominal"), {moment(0, 0)});
        (void)hand.read(kTick);
        for (int tick = 0; tick <= delay; ++tick) {
            EXPECT_EQ(hand.tip().x(), 0) << tick << " of " << delay;
            hand.write(push(2));
            (void)hand.read(kTick);
        }
        EXPECT_GT(hand.tip().x(), 0);
    }
}

TEST(SimulatedDevice, TrembleIsAsStrongAsAsked) {
    SimulatedDevice hand(ideal(), {"held by a vice", 1e-6, 1, 100}, {moment(0, 0)}, {.tremor = 0.038});
    double squares = 0;
    constexpr int kTicks = 20'000;
    for (int i = 0; i < kTicks; ++i) squares += hand.read(kTick).hand.position.squaredNorm();
    EXPECT_NEAR(std::sqrt(squares / kTicks), 0.038, 0.002);
}

TEST(SimulatedDevice, APenThatIsLetGoIsMovedByTheForceAlone) {
    SimulatedDevice hand(ideal(), *findHandImpedance("nominal"), {moment(0, 0)}, {.releaseTime = 0});
    (void)hand.read(kTick);
    hand.write(push(1));
    for (int i = 0; i < 10; ++i) (void)hand.read(kTick);
    EXPECT_NEAR(hand.speed().x(), 0.01 / ideal().inertia, 1e-6);
}

TEST(SimulatedDevice, EqualScriptsGiveEqualBitsAndOpeningStartsAnew) {
    SimulatedDevice hand(*findDevicePreset("omni"), *findHandImpedance("loose"), {moment(0, 0), moment(0.2, 4)},
                         {.tremor = 0.05});
    const auto run = [&] {
        EXPECT_TRUE(hand.open());
        for (int i = 0; i < 300; ++i) {
            (void)hand.read(kTick);
            hand.write(push(std::sin(0.1 * i)));
        }
        return hand.tip();
    };
    const Vec3 first = run();
    EXPECT_EQ(run(), first);
}

TEST(SimulatedDevice, ReportsTheLimitsOfItsDevice) {
    const SimulatedDevice hand(*findDevicePreset("omni"), *findHandImpedance("loose"), {moment(0, 0)});
    EXPECT_EQ(hand.info().limits.force, 3.3);
    EXPECT_EQ(hand.info().limits.continuousForce, 0.88);
    EXPECT_EQ(hand.info().stiffness, 0.5);
    EXPECT_EQ(hand.info().name, "PHANToM Omni (simulated)");
}

}  // namespace
}  // namespace tactooth
