// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/kernel/tick_input.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace tactooth {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

OperatorInput randomInput(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-60, 60), part(-1, 1);
    OperatorInput input;
    input.deviceInTooth.position = Vec3(place(random), place(random), place(random));
    input.deviceInTooth.rotation = Quat(part(random), part(random), part(random), part(random)).normalized();
    input.pedal = std::abs(part(random));
    input.cutting = part(random) > 0;
    return input;
}

TEST(TickInput, IsTheNearestPointOfTheGrid) {
    std::mt19937 random(11);
    for (int i = 0; i < 2000; ++i) {
        const OperatorInput input = randomInput(random);
        const OperatorInput rounded = TickInput::of(input, 0.001).operatorInput();
        const Vec3 shift = rounded.deviceInTooth.position - input.deviceInTooth.position;
        EXPECT_LE(shift.cwiseAbs().maxCoeff(), TickInput::kPositionStep / 2);
        const Eigen::Vector4d turn = rounded.deviceInTooth.rotation.coeffs() - input.deviceInTooth.rotation.coeffs();
        EXPECT_LE(turn.cwiseAbs().maxCoeff(), TickInput::kRotationStep / 2);
        EXPECT_LE(std::abs(rounded.pedal - input.pedal), TickInput::kPedalStep / 2);
        EXPECT_EQ(rounded.cutting, input.cutting);
        EXPECT_TRUE(isRigid(rounded.deviceInTooth));
    }
}

TEST(TickInput, OfAnInputOnTheGridIsTheSame) {
    std::mt19937 random(12);
    for (int i = 0; i < 2000; ++i) {
        const TickInput once = TickInput::of(randomInput(random), 1e-6 * static_cast<double>(random() % 30000));
        EXPECT_EQ(TickInput::of(once.operatorInput(), once.seconds()), once);
    }
}

TEST(TickInput, WithoutAValidPoseHasNone) {
    for (const double bad : {kNaN, kInfinity, -kInfinity, 1e7, -1e300}) {
        OperatorInput input;
        input.deviceInTooth.position.y() = bad;
        const TickInput rounded = TickInput::of(input, 0.001);
        EXPECT_FALSE(rounded.hasPose);
        EXPECT_TRUE(rounded.operatorInput().deviceInTooth.position.array().isNaN().all());
    }
    OperatorInput turned;
    turned.deviceInTooth.rotation.x() = kNaN;
    EXPECT_FALSE(TickInput::of(turned, 0.001).hasPose);
}

TEST(TickInput, CountsATimeThatIsNoneAsZero) {
    for (const double bad : {kNaN, kInfinity, -kInfinity, -0.1, 1e9})
        EXPECT_EQ(TickInput::of({}, bad).elapsed, 0) << bad;
    EXPECT_EQ(TickInput::of({}, 0.5).seconds(), 0.5);
}

TEST(TickInput, KeepsThePedalWithinItsTravel) {
    for (const auto& [given, kept] : {std::pair(-1.0, 0.0), std::pair(7.0, 1.0), std::pair(kNaN, 0.0)}) {
        OperatorInput input;
        input.pedal = given;
        EXPECT_EQ(TickInput::of(input, 0.001).operatorInput().pedal, kept);
    }
}

/// A clock of 3 kHz is not on the grid: the sum of a minute is still right.
TEST(ElapsedTime, LosesNothingByRounding) {
    std::mt19937 random(13);
    std::uniform_real_distribution<double> jitter(-1e-4, 1e-4);
    ElapsedTime time;
    double real = 0, used = 0;
    for (int i = 0; i < 180'000; ++i) {
        const double elapsed = 1.0 / 3000 + jitter(random);
        real += elapsed;
        const double next = time.next(elapsed);
        EXPECT_EQ(TickInput::of({}, next).seconds(), next);
        used += next;
    }
    EXPECT_NEAR(used, real, 2 * TickInput::kTimeStep);
}

TEST(ElapsedTime, PassesWhatIsNoTime) {
    ElapsedTime time;
    EXPECT_TRUE(std::isnan(time.next(kNaN)));
    EXPECT_EQ(time.next(0.25), 0.25);
}

}  // namespace
}  // namespace tactooth
