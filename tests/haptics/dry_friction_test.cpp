// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/dry_friction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tactooth {
namespace {

constexpr double kStiffness = 0.5;  // N/mm
constexpr double kMost = 0.15;      // N
const Vec3 kUp = Vec3::UnitZ();

Vec3 pull(DryFriction& friction, const Vec3& hand, double rimTravel = 0) {
    return friction.at(hand, kUp, kStiffness, kMost, rimTravel);
}

TEST(DryFriction, SticksLikeASpringAndThenSlides) {
    DryFriction friction;
    EXPECT_EQ(pull(friction, Vec3(3, 4, 5)), Vec3::Zero());
    EXPECT_TRUE(pull(friction, Vec3(3.1, 4, 5)).isApprox(Vec3(-0.05, 0, 0), 1e-12));
    EXPECT_TRUE(pull(friction, Vec3(13, 4, 5)).isApprox(Vec3(-0.15, 0, 0), 1e-12));
    EXPECT_TRUE(pull(friction, Vec3(13, 4, 5)).isApprox(Vec3(-0.15, 0, 0), 1e-12)) << "and holds where it stops";
    EXPECT_TRUE(pull(friction, Vec3(12.7, 4, 5)).isZero(1e-12)) << "the place is 0.3 mm behind";
    EXPECT_TRUE(pull(friction, Vec3(12, 4, 5)).isApprox(Vec3(0.15, 0, 0), 1e-12));
}

TEST(DryFriction, ActsAcrossTheNormalAlone) {
    DryFriction friction;
    std::mt19937 random(20261121);
    std::uniform_real_distribution<double> within(-1, 1);
    const auto any = [&] { return Vec3(within(random), within(random), within(random)); };
    Vec3 hand = any();
    int slid = 0;
    for (int i = 0; i < 10'000; ++i) {
        hand += 0.1 * any();
        const Vec3 normal = any().normalized();
        const Vec3 force = friction.at(hand, normal, kStiffness, kMost, 0);
        EXPECT_NEAR(force.dot(normal), 0, 1e-15);
        EXPECT_LE(force.norm(), kMost * (1 + 1e-12));
        EXPECT_NEAR(friction.deflection().norm() * kStiffness, force.norm(), 1e-15);
        slid += force.norm() > 0.999 * kMost;
    }
    EXPECT_GT(slid, 100);
    EXPECT_LT(slid, 9'900);
}

/// A trembling hand, measured in encoder steps: no more work comes out than went in.
TEST(DryFriction, ReturnsNoMoreWorkThanItTook) {
    constexpr double kStep = 0.023;  // mm
    DryFriction friction;
    std::mt19937 random(7);
    Vec3 hand = Vec3::Zero();
    Vec3 force = pull(friction, hand);
    double work = 0;  // N*mm, of the hand
    for (int i = 0; i < 100'000; ++i) {
        const Vec3 before = hand;
        if (random() % 8 == 0) hand[random() % 2] += random() % 2 == 0 ? kStep : -kStep;
        // The force of the tick before is held until this one: half a step leaks, and the device's own friction removes
        // it.
        work -= 0.5 * (force.dot(hand - before));
        force = pull(friction, hand);
        work -= 0.5 * (force.dot(hand - before));
        ASSERT_GE(work, 0.5 * force.squaredNorm() / kStiffness - 1e-9);
    }
    EXPECT_GT(work, 1) << "it was dragged about";
}

TEST(DryFriction, ATurningRimReleasesIt) {
    DryFriction friction;
    (void)pull(friction, Vec3::Zero());
    (void)pull(friction, Vec3(0.2, 0, 0));
    const double before = friction.deflection().norm();
    EXPECT_NEAR(pull(friction, Vec3(0.2, 0, 0), 0.05).norm(), kStiffness * before / std::exp(1), 1e-12);
    EXPECT_LT(pull(friction, Vec3(0.4, 0, 0), 20).norm(), 1e-12);
}

TEST(DryFriction, IsZeroWithoutNormalForce) {
    DryFriction friction;
    (void)pull(friction, Vec3::Zero());
    EXPECT_EQ(friction.at(Vec3(1, 0, 0), kUp, kStiffness, 0, 0), Vec3::Zero());
    EXPECT_EQ(friction.at(Vec3(2, 0, 0), kUp, 0, kMost, 0), Vec3::Zero());
}

TEST(DryFriction, ANewContactStartsWithoutDeflection) {
    DryFriction friction;
    (void)pull(friction, Vec3::Zero());
    friction.reset();
    EXPECT_EQ(pull(friction, Vec3(5, 5, 5)), Vec3::Zero());
}

}  // namespace
}  // namespace tactooth
