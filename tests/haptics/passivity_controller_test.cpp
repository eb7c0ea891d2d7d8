// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/passivity_controller.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/servo_tick.h"

namespace tactooth {
namespace {

using test::kTick;
constexpr double kStiffness = 1;  // N/mm
constexpr double kBound = 100;    // N: never reached

Vec3 at(double z) { return {0, 0, z}; }

SpringState springAt(double z, double stiffness = kStiffness, double bound = kBound) {
    return {std::max(0.0, -z), stiffness, bound, 1};
}

TEST(PassivityController, TheSumIsTheWorkOfTheHandLessTheEnergyOfTheSpring) {
    PassivityController controller;
    (void)controller.damp(at(0), Vec3::Zero(), springAt(0), kTick);
    // Half a tick's force is missing on the way in: k * dx^2 / 2 a tick.
    double z = 0;
    for (int i = 0; i < 5; ++i) {
        const Vec3 held(0, 0, kStiffness * -z);
        z -= 0.05;
        (void)controller.damp(at(z), held, springAt(z), kTick);
    }
    EXPECT_NEAR(controller.energy(), -5 * 0.5 * kStiffness * 0.05 * 0.05, 1e-12);
}

TEST(PassivityController, WorkOfTheHandGivesBoundedCredit) {
    PassivityController controller;
    (void)controller.damp(at(0), Vec3::Zero(), springAt(0), kTick);
    for (int i = 1; i < 5000; ++i) {
        const Vec3 added = controller.damp(Vec3(0.01 * i, 0, 0), Vec3(-0.5, 0, 0), springAt(0), kTick);
        ASSERT_EQ(added, Vec3::Zero()) << "there is nothing to take out";
    }
    EXPECT_EQ(controller.energy(), 0.02);
}

TEST(PassivityController, MissingEnergyIsRemovedByDamping) {
    PassivityController controller;
    (void)controller.damp(at(0), Vec3::Zero(), springAt(0), kTick);
    const Vec3 added = controller.damp(at(-0.02), Vec3::Zero(), springAt(-0.02), kTick);
    // At the same speed, the damper removes in one tick what is missing, and what the next step will leak.
    const double speedShare = 1 - std::exp(-kTick / 0.005);  // of the low-pass after one tick
    EXPECT_NEAR(added.z() * 0.02, speedShare * kStiffness * 0.02 * 0.02, 1e-12);
    EXPECT_EQ(added.x(), 0);
}

TEST(PassivityController, DampsBeforeTheSumIsNegative) {
    PassivityController controller;
    double z = 0;
    (void)controller.damp(at(z), Vec3::Zero(), springAt(z), kTick);
    z = -0.05;  // energy for 2.5 steps of 0.02 mm, each of which leaks 0.0002 N*mm
    (void)controller.damp(at(z), at(0.5 * kStiffness * 0.05 + 0.01), springAt(z), kTick);
    EXPECT_NEAR(controller.energy(), 0.0005, 1e-12);
    for (int step = 1; step <= 2; ++step) {
        const Vec3 held = at(kStiffness * -z);
        z -= 0.02;
        (void)controller.damp(at(z), held, springAt(z), kTick);
    }
    EXPECT_NEAR(controller.energy(), 0.0001, 1e-12);
    const Vec3 held = at(kStiffness * -z);
    z -= 0.005;
    const Vec3 added = controller.damp(at(z), held, springAt(z), kTick);
    EXPECT_GT(controller.energy(), 0);
    EXPECT_GT(added.z(), 0) << "there is not the energy for another step as before";
}

/// Work that the damper removes from a hand that moves an encoder by 0.05 mm every `pause` ticks, for each step, N*mm.
double eatenByStep(int pause) {
    PassivityController controller;
    (void)controller.damp(at(-1), Vec3::Zero(), springAt(-1), kTick);
    double z = -1;
    Vec3 added = Vec3::Zero();
    double eaten = 0;
    constexpr int kSteps = 20;
    for (int tick = 1; tick <= kSteps * pause; ++tick) {
        const double step = tick % pause == 0 ? -0.05 : 0;
        z += step;
        eaten += -added.z() * step;
        added = controller.damp(at(z), at(kStiffness * -(z - step)), springAt(z), kTick);
    }
    return eaten / kSteps;
}

TEST(PassivityController, DampsAHandWhoseEncoderRestsBetweenSteps) {
    const double leak = 0.5 * kStiffness * 0.05 * 0.05;
    EXPECT_GT(eatenByStep(2), 0.9 * leak);
    // The damper's bound allows 0.005 N*s/mm at 5 mm/s over 0.05 mm; 0.98^9 of it is left at the end of a pause, and
    // the first of the 20 steps is not damped.
    EXPECT_NEAR(eatenByStep(10), 0.95 * std::pow(0.98, 9) * 0.005 * 5 * 0.05, 2e-5);
}

TEST(PassivityController, DoesNotDampAHandAtRest) {
    PassivityController controller;
    (void)controller.damp(at(-1), Vec3::Zero(), springAt(-1), kTick);
    for (int i = 1; i <= 5; ++i) (void)controller.damp(at(-1 - 0.05 * i), at(0), springAt(-1 - 0.05 * i), kTick);
    Vec3 added = Vec3::Zero();
    for (int i = 0; i < 30; ++i) added = controller.damp(at(-1.25), at(1.25), springAt(-1.25), kTick);
    EXPECT_LT(added.norm(), 0.001);
}

TEST(PassivityController, TheDamperIsBounded) {
    PassivityController controller;
    (void)controller.damp(at(0), Vec3::Zero(), springAt(0), kTick);
    const Vec3 added = controller.damp(at(-0.02), Vec3(0, 0, -50), springAt(-0.02), kTick);
    EXPECT_NEAR(added.norm(), (1 - std::exp(-kTick / 0.005)) * 0.005 * 0.02 / kTick, 1e-12);
}

TEST(PassivityController, TheDevicesFrictionDissipatesTheEnergyOfSmallSteps) {
    PassivityController controller(0.06);
    double z = 0;
    (void)controller.damp(at(z), Vec3::Zero(), springAt(z), kTick);
    for (int i = 0; i < 20; ++i) {
        const Vec3 held(0, 0, kStiffness * -z);
        z -= 0.023;  // an encoder step: leaks 0.00026 N*mm, and friction removes 0.00069
        ASSERT_EQ(controller.damp(at(z), held, springAt(z), kTick), Vec3::Zero());
    }
    EXPECT_GT(controller.energy(), 0);
}

TEST(PassivityController, ASpringThatIsCutOffStoresNoMoreThanItReturns) {
    PassivityController controller;
    const double bound = 1;
    (void)controller.damp(at(-2), Vec3::Zero(), springAt(-2, kStiffness, bound), kTick);
    (void)controller.damp(at(-2.1), Vec3(0, 0, bound), springAt(-2.1, kStiffness, bound), kTick);
    EXPECT_NEAR(controller.energy(), 0, 1e-12) << "0.1 mm against 1 N, and as much is held";
}

TEST(PassivityController, ASpringThatBecomesStifferIsALeak) {
    PassivityController controller;
    (void)controller.damp(at(-1), Vec3::Zero(), springAt(-1, 0.5), kTick);
    (void)controller.damp(at(-1), Vec3(0, 0, 0.5), springAt(-1, 0.8), kTick);
    EXPECT_NEAR(controller.energy(), -0.15, 1e-12);
}

/// A mass on a sampled spring: without damping its oscillation grows.
double widestSwing(bool controlled) {
    PassivityController controller;
    const double mass = 1e-4;  // N*s^2/mm: 100 g
    double z = -1.0;
    double speed = 0;
    double widest = 0;
    Vec3 force = Vec3::Zero();
    for (int tick = 0; tick < 3000; ++tick) {
        const Vec3 added = controller.damp(at(z), force, springAt(z), kTick);
        force = at(kStiffness * -z - 1);  // the hand leans on it with 1 N
        if (controlled) force += added;
        force.z() += 1;  // the observer gets the force of the tooth only
        constexpr int kParts = 20;
        for (int part = 0; part < kParts; ++part) {
            speed += (force.z() - 1) / mass * kTick / kParts;
            z += speed * kTick / kParts;
        }
        if (tick == 0) speed += 5;
        if (tick > 2500) widest = std::max(widest, std::abs(z + 1));
        if (widest > 0.9) break;
    }
    return widest;
}

TEST(PassivityController, StopsTheOscillationOfASampledSpring) {
    EXPECT_GT(widestSwing(false), 0.1);
    EXPECT_LT(widestSwing(true), 0.06);
}

TEST(PassivityController, ResetForgetsEnergyAndDamper) {
    PassivityController controller;
    (void)controller.damp(at(0), Vec3::Zero(), springAt(0), kTick);
    (void)controller.damp(at(-0.1), Vec3::Zero(), springAt(-0.1), kTick);
    EXPECT_LT(controller.energy(), 0);
    controller.reset();
    EXPECT_EQ(controller.energy(), 0);
    EXPECT_EQ(controller.damp(at(5), Vec3::Zero(), springAt(0), kTick), Vec3::Zero());
}

TEST(PassivityController, SumsThatAreNotFiniteGiveNaNAndStartAnew) {
    const double bad = std::nan("");
    const auto spoiled = [&](int what) {
        PassivityController controller;
        (void)controller.damp(at(0), Vec3::Zero(), springAt(0), kTick);
        SpringState spring = springAt(-0.1);
        if (what == 0) spring.deflection = spring.stiffness = bad;
        if (what == 3) spring.bound = bad;
        if (what == 4) spring.strength = bad;
        const Vec3 added = controller.damp(what == 1 ? at(bad) : at(-0.1), what == 2 ? at(bad) : at(0), spring, kTick);
        EXPECT_TRUE(std::isfinite(controller.energy())) << what;
        (void)controller.damp(at(0), Vec3::Zero(), springAt(0), kTick);
        const Vec3 later = controller.damp(at(-0.02), Vec3::Zero(), springAt(-0.02), kTick);
        EXPECT_TRUE(later.allFinite()) << what;
        EXPECT_GT(later.z(), 0) << what;
        return added.allFinite();
    };
    for (const int what : {1, 2, 3, 4}) EXPECT_FALSE(spoiled(what)) << what;
    EXPECT_TRUE(spoiled(0)) << "a spring that is none holds nothing";
}

}  // namespace
}  // namespace tactooth
