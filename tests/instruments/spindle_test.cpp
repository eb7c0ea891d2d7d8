// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/spindle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace tactooth {
namespace {

constexpr double kRadPerSecPerRpm = std::numbers::pi / 30;

const SpindlePreset& turbine() { return spindlePresets()[0]; }
const SpindlePreset& electric() { return spindlePresets()[1]; }

double timeConstantOf(const SpindlePreset& preset) {
    return preset.inertia * preset.droopRpm * kRadPerSecPerRpm / preset.stallTorque;
}

SpindleState runFor(const SpindlePreset& preset, SpindleState state, double pedal, double load, double seconds) {
    for (int tick = 0; tick < std::lround(seconds * 1000); ++tick)
        state = stepSpindle(preset, state, pedal, load, 0.001);
    return state;
}

TEST(Spindle, TurbineReachesSixtyThreePercentAfterOneTimeConstant) {
    const double tau = timeConstantOf(turbine());
    EXPECT_GT(tau, 0.3);
    EXPECT_LT(tau, 0.6);
    const SpindleState state = stepSpindle(turbine(), {}, 1, 0, tau);
    EXPECT_NEAR(state.speedRpm, turbine().freeSpeedRpm * (1 - std::exp(-1)), 1);
}

TEST(Spindle, ThousandSmallStepsEqualOneLargeStep) {
    const SpindleState fine = runFor(turbine(), {}, 0.8, 0.3, 1.0);
    EXPECT_NEAR(fine.speedRpm, stepSpindle(turbine(), {}, 0.8, 0.3, 1.0).speedRpm, 1e-6);
}

TEST(Spindle, LoadedTurbineSettlesWhereTheTorqueLineSays) {
    const double load = 0.5 * 0.5;  // 0.5 N at the rim of a 1 mm bur
    const double expected = turbine().freeSpeedRpm * (1 - load / turbine().stallTorque);
    EXPECT_NEAR(runFor(turbine(), {turbine().freeSpeedRpm}, 1, load, 10).speedRpm, expected, 1e-3);
    EXPECT_NEAR(expected / turbine().freeSpeedRpm, 0.82, 0.005);
}

TEST(Spindle, TorqueLineGivesTheTurbinesPower) {
    const double half = turbine().freeSpeedRpm / 2;
    const double watts = driveTorque(turbine(), half, 1) * 1e-3 * half * kRadPerSecPerRpm;
    EXPECT_NEAR(watts, 15, 0.5);
    EXPECT_EQ(driveTorque(turbine(), 0, 1), turbine().stallTorque);
    EXPECT_NEAR(driveTorque(turbine(), turbine().freeSpeedRpm, 1), 0, 1e-9);
}

TEST(Spindle, StallsAtTheStallTorqueAndRunsAgainBelowIt) {
    SpindleState state = runFor(turbine(), {turbine().freeSpeedRpm}, 1, turbine().stallTorque * 1.01, 10);
    EXPECT_EQ(state.speedRpm, 0);
    state = runFor(turbine(), state, 1, turbine().stallTorque * 1.01, 1);
    EXPECT_EQ(state.speedRpm, 0);
    EXPECT_GT(runFor(turbine(), state, 1, turbine().stallTorque * 0.9, 1).speedRpm, 0);
}

TEST(Spindle, ReleasedPedalLetsTheBurRunDown) {
    const double tau = timeConstantOf(turbine());
    EXPECT_NEAR(stepSpindle(turbine(), {400000}, 0, 0, tau).speedRpm, 400000 * std::exp(-1), 1);
    EXPECT_EQ(stepSpindle(turbine(), {400000}, 0, 0.2, 100).speedRpm, 0);
}

TEST(Spindle, PedalFollowsTheRootOfThePressureAboveItsDeadBand) {
    EXPECT_EQ(targetSpeedRpm(turbine(), 0.0), 0);
    EXPECT_EQ(targetSpeedRpm(turbine(), turbine().pedalDeadBand), 0);
    EXPECT_NEAR(targetSpeedRpm(turbine(), 0.1 + 0.9 * 0.25), turbine().freeSpeedRpm / 2, 1e-6);
    EXPECT_EQ(targetSpeedRpm(turbine(), 1.0), turbine().freeSpeedRpm);
    EXPECT_EQ(targetSpeedRpm(turbine(), 7.0), turbine().freeSpeedRpm);
}

TEST(Spindle, ElectricPedalIsLinearFromTheLowestSpeed) {
    EXPECT_EQ(targetSpeedRpm(electric(), 0), 0);
    EXPECT_NEAR(targetSpeedRpm(electric(), electric().pedalDeadBand + 1e-9), electric().minSpeedRpm, 1);
    const double middle = electric().pedalDeadBand + (1 - electric().pedalDeadBand) / 2;
    EXPECT_NEAR(targetSpeedRpm(electric(), middle), (electric().minSpeedRpm + electric().freeSpeedRpm) / 2, 1e-6);
}

TEST(Spindle, ElectricHoldsItsSpeedWhereTheTurbineGivesWay) {
    const double load = 0.5;
    const double lossOfElectric = 1 - runFor(electric(), {200000}, 1, load, 5).speedRpm / 200000;
    const double lossOfTurbine = 1 - runFor(turbine(), {400000}, 1, load, 5).speedRpm / 400000;
    EXPECT_LT(lossOfElectric, 0.01);
    EXPECT_GT(lossOfTurbine, 0.3);
}

TEST(Spindle, ElectricSpinsUpAtItsFullTorque) {
    const double acceleration = electric().stallTorque / electric().inertia / kRadPerSecPerRpm;  // rev/min per s
    EXPECT_NEAR(stepSpindle(electric(), {}, 1, 0, 0.1).speedRpm, acceleration * 0.1, 1e-6);
    const double seconds = electric().freeSpeedRpm / acceleration;
    EXPECT_GT(seconds, 0.2);
    EXPECT_LT(seconds, 0.5);
}

TEST(Spindle, ElectricBrakesToAStandstillWithinHalfASecond) {
    EXPECT_LT(stepSpindle(electric(), {200000}, 0, 0, 0.5).speedRpm, 1);
}

TEST(Spindle, ElectricStallsAboveItsTorque) {
    EXPECT_EQ(runFor(electric(), {200000}, 1, electric().stallTorque * 1.1, 10).speedRpm, 0);
}

/// Reference: the equation of motion by tiny explicit Euler steps.
double integrate(const SpindlePreset& preset, double speedRpm, double pedal, double load, double seconds) {
    constexpr int kSteps = 200000;
    for (int i = 0; i < kSteps; ++i) {
        const double torque = driveTorque(preset, speedRpm, pedal) - load;
        speedRpm = std::max(0.0, speedRpm + torque / preset.inertia * (seconds / kSteps) / kRadPerSecPerRpm);
    }
    return speedRpm;
}

TEST(Spindle, AgreesWithNumericalIntegrationForRandomLoads) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const SpindlePreset& preset : spindlePresets()) {
        for (int i = 0; i < 20; ++i) {
            const double start = unit(random) * preset.freeSpeedRpm, pedal = unit(random);
            const double load = 1.3 * unit(random) * preset.stallTorque, seconds = unit(random) * 0.6;
            const double expected = integrate(preset, start, pedal, load, seconds);
            EXPECT_NEAR(stepSpindle(preset, {start}, pedal, load, seconds).speedRpm, expected,
                        2e-4 * preset.freeSpeedRpm)
                << preset.name << " start " << start << " pedal " << pedal << " load " << load << " for " << seconds;
        }
    }
}

}  // namespace
}  // namespace tactooth
