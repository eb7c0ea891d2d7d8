// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/cutting_force.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "support/servo_tick.h"

namespace tactooth {
namespace {

using test::kTick;
constexpr double kTurbine = 300'000;  // rev/min

CuttingContact cutting(double normalForce, double speedRpm = kTurbine, const Vec3& normal = Vec3::UnitX()) {
    return {normal, Vec3::UnitZ(), normalForce, speedRpm, kTurbine};
}

/// Forces after the engagement is complete.
std::vector<Vec3> settled(const CuttingContact& contact, int ticks = 1000) {
    CuttingForce law;
    for (int i = 0; i < 500; ++i) (void)law.at(contact, kTick);
    std::vector<Vec3> forces;
    for (int i = 0; i < ticks; ++i) forces.push_back(law.at(contact, kTick));
    return forces;
}

Vec3 meanOf(const std::vector<Vec3>& forces) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& force : forces) sum += force;
    return sum / static_cast<double>(forces.size());
}

TEST(CuttingForce, PullsByHalfTheNormalForceAgainstTheRotation) {
    // Clockwise seen from the shaft (+z): the rim at -x, where the tooth is, moves toward +y.
    const Vec3 mean = meanOf(settled(cutting(2)));
    EXPECT_NEAR(mean.y(), -1.0, 1e-3);
    EXPECT_NEAR(mean.x(), 0, 1e-3);
    EXPECT_NEAR(mean.z(), 0, 1e-12);
}

TEST(CuttingForce, DoesNotPullABurThatCutsWithItsEnd) {
    EXPECT_NEAR(meanOf(settled(cutting(2, kTurbine, Vec3::UnitZ()))).norm(), 0, 1e-3);
}

TEST(CuttingForce, IsZeroForABurAtRestAndInTheAir) {
    for (const Vec3& force : settled(cutting(2, 0))) ASSERT_EQ(force.norm(), 0);
    for (const Vec3& force : settled(cutting(0))) ASSERT_EQ(force.norm(), 0);
}

TEST(CuttingForce, VibratesAtMostWith250Hertz) {
    const double frequency = CuttingForce::vibrationFrequency(kTurbine, kTurbine);
    EXPECT_EQ(frequency, 5000.0 / 32);
    for (double free = 300; free < 500'000; free *= 1.07) {
        EXPECT_LE(CuttingForce::vibrationFrequency(free, free), 250) << free;
        EXPECT_DOUBLE_EQ(CuttingForce::vibrationFrequency(free / 3, free),
                         CuttingForce::vibrationFrequency(free, free) / 3);
    }
    EXPECT_DOUBLE_EQ(CuttingForce::vibrationFrequency(10'000, 10'000), 10'000 / 60.0);
}

TEST(CuttingForce, VibratesAtOneFrequencyWithFourPercentOfTheNormalForce) {
    const std::vector<Vec3> forces = settled(cutting(1));
    const Vec3 mean = meanOf(forces);
    double power = 0;    // of the shaking, N^2
    double atPitch = 0;  // of it at the one frequency
    double real = 0;
    double imaginary = 0;
    const double turn = 2 * std::numbers::pi * kTick * CuttingForce::vibrationFrequency(kTurbine, kTurbine);
    for (std::size_t i = 0; i < forces.size(); ++i) {
        const Vec3 shake = forces[i] - mean;
        ASSERT_NEAR(shake.norm(), 0.04, 1e-3);
        power += shake.x() * shake.x();
        real += shake.x() * std::cos(turn * static_cast<double>(i));
        imaginary += shake.x() * std::sin(turn * static_cast<double>(i));
    }
    atPitch = 2 * (real * real + imaginary * imaginary) / static_cast<double>(forces.size());
    EXPECT_GT(atPitch, 0.99 * power);
}

TEST(CuttingForce, StartsAndEndsWithoutAStep) {
    CuttingForce law;
    Vec3 last = Vec3::Zero();
    const double ofVibration = 0.04 * 2 * std::sin(std::numbers::pi * kTick * 5000 / 32);  // from tick to tick, N
    for (int i = 0; i < 400; ++i) {
        const Vec3 force = law.at(cutting(1, i < 200 ? kTurbine : 0), kTick);
        EXPECT_LT((force - last).norm(), 0.03 + ofVibration) << i;
        last = force;
    }
    EXPECT_NEAR(last.norm(), 0, 1e-4);
}

}  // namespace
}  // namespace tactooth
