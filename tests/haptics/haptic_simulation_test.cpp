// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/haptic_simulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

#include "scene.h"
#include "support/materials.h"
#include "support/servo_tick.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using test::at;

using test::kTick;
constexpr double kRounding = 1e-6;
const MaterialTable kMaterials;

HapticSimulation simulationOf(const HapticSettings& settings = {},
                              std::shared_ptr<const Surface> surface = test::block()) {
    return {test::ball(), test::kBallRadius, std::move(surface), settings};
}

OperatorInput touching(const Pose& hand) { return {hand, 0, false}; }
OperatorInput cutting(const Pose& hand, double pedal = 1) { return {hand, pedal, true}; }

double rimSpeed(double rpm) { return rpm / 60 * 2 * std::numbers::pi * test::kBallRadius * 1e-3; }

/// Whether all fields are equal, bit for bit.
bool equalBits(const Tick& a, const Tick& b) {
    const auto numbers = [](const Tick& t) {
        std::vector<double> all = {t.time,
                                   t.contact.depth,
                                   t.input.speed,
                                   double(t.contact.triangles),
                                   t.input.pedal,
                                   t.spindle.speedRpm,
                                   t.spindle.load,
                                   t.spindle.removalPower,
                                   t.spindle.cutWork,
                                   t.contact.impactSpeed,
                                   t.contact.slideSpeed,
                                   t.contact.pullOutForce};
        for (const Vec3& v : {t.input.device.position, t.contact.proxy.position, t.contact.normal, t.force.wrench.force,
                              t.force.wrench.torque}) {
            all.insert(all.end(), v.data(), v.data() + 3);
        }
        for (const Quat& q : {t.input.device.rotation, t.contact.proxy.rotation}) {
            all.insert(all.end(), q.coeffs().data(), q.coeffs().data() + 4);
        }
        return all;
    };
    const std::vector<double> first = numbers(a);
    const std::vector<double> second = numbers(b);
    return std::memcmp(first.data(), second.data(), first.size() * sizeof(double)) == 0 &&
           a.contact.placed == b.contact.placed && a.input.cutting == b.input.cutting &&
           a.contact.material == b.contact.material && a.contact.onsets == b.contact.onsets &&
           a.contact.pullOuts == b.contact.pullOuts;
}

/// A device that moves about the top of the block, rotates, and cuts now and then.
std::vector<OperatorInput> wandering(int ticks) {
    std::mt19937 random(20260205);
    std::normal_distribution<double> step(0, 0.02);
    std::vector<OperatorInput> result;
    Pose hand = at(0, 0, 0.1);
    for (int i = 0; i < ticks; ++i) {
        hand.position += Vec3(step(random), step(random), step(random) - 0.02 * hand.position.z());
        const Vec3 axis = Vec3(step(random), step(random), step(random)).normalized();
        hand.rotation = (Quat(Eigen::AngleAxisd(step(random), axis)) * hand.rotation).normalized();
        result.push_back({hand, i % 500 / 500.0, i / 300 % 2 == 1});
    }
    return result;
}

TEST(HapticSimulation, SteadyPenetrationOfAPlaneIsKelvinVoigt) {
    for (const double speed : {0.5, 5.0, 40.0}) {
        HapticSimulation simulation = simulationOf();
        const Material& enamel = kMaterials[test::kEnamel];
        for (int i = 0; i < 60; ++i) {
            const double z = 0.02 * speed - speed * kTick * i;
            const Tick tick = simulation.step(touching(at(0.1, 0.2, z)), kTick);
            if (i < 21) continue;                                                        // not in contact yet
            const double unsettled = 2 * enamel.damping * speed * std::exp(-0.628 * i);  // of the low-pass of the speed
            ASSERT_NEAR(tick.contact.depth, -z, kRounding);
            ASSERT_NEAR(tick.force.wrench.force.z(), enamel.stiffness * -z + enamel.damping * speed, 2e-6 + unsettled);
            ASSERT_NEAR(tick.force.wrench.force.head<2>().norm(), 0, kRounding);
            ASSERT_NEAR(tick.contact.normal.z(), 1, kRounding);
            ASSERT_NEAR(tick.input.speed, speed, 1e-9);
            ASSERT_EQ(tick.contact.material, test::kEnamel);
        }
    }
}

TEST(HapticSimulation, AToolSlidesAsFastAsItsProxyMovesAlongTheSurface) {
    constexpr double kSpeed = 20;  // mm/s
    HapticSimulation simulation = simulationOf();
    for (int i = 0; i < 40; ++i) {
        // Down until 0.2 mm below the surface, then along it, then still.
        const double x = kSpeed * kTick * std::clamp(i - 10, 0, 20);
        const double z = std::max(-0.2, 0.1 - 0.05 * i);
        const Tick tick = simulation.step(touching(at(x, 0.2, z)), kTick);
        const bool slides = i > 10 && i <= 30;
        ASSERT_NEAR(tick.contact.slideSpeed, slides ? kSpeed : 0, 1e-6) << i;
    }
    EXPECT_EQ(simulation.step(touching(at(0, 0, 1)), kTick).contact.slideSpeed, 0) << "in the air";
}

TEST(HapticSimulation, ARotationThatIsNearlyUnitCountsAsTheUnitOne) {
    HapticSimulation exact = simulationOf(), rough = simulationOf();
    for (int i = 0; i < 300; ++i) {
        Pose pose = at(0.1, 0.2, 0.1 - 0.001 * i);
        pose.rotation = Quat(Eigen::AngleAxisd(0.01 * i, Vec3(1, 2, 3).normalized()));
        const Tick wanted = exact.step(touching(pose), kTick);
        pose.rotation.coeffs() *= 1.0004;
        const Tick found = rough.step(touching(pose), kTick);
        ASSERT_NEAR((found.force.wrench.force - wanted.force.wrench.force).norm(), 0, 1e-9) << i;
        ASSERT_NEAR((found.contact.proxy.position - wanted.contact.proxy.position).norm(), 0, 1e-9) << i;
        ASSERT_NEAR(found.contact.proxy.rotation.squaredNorm(), 1, 1e-12) << i;
    }
}

TEST(HapticSimulation, OverridesReplaceTheMaterial) {
    HapticSettings settings;
    settings.force = {.stiffness = 2.5, .damping = 0.0, .friction = 0.0};
    HapticSimulation simulation = simulationOf(settings);
    simulation.step(touching(at(0, 0, 0.1)), kTick);
    for (int i = 0; i < 5; ++i) simulation.step(touching(at(0, 0, -0.2)), kTick);
    EXPECT_NEAR(simulation.step(touching(at(0, 0, -0.2)), kTick).force.wrench.force.z(), 0.5, 5 * kRounding);
}

TEST(HapticSimulation, TimeIsTheSumOfTheSteps) {
    HapticSimulation simulation = simulationOf();
    EXPECT_EQ(simulation.step(touching(at(0, 0, 1)), kTick).time, 0);
    EXPECT_EQ(simulation.step(touching(at(0, 0, 1)), 0.25).time, 0.25);
    EXPECT_EQ(simulation.step(touching(at(0, 0, 1)), 0.5).time, 0.75);
}

TEST(HapticSimulation, CountsContactOnsetsWithTheirSpeed) {
    HapticSimulation simulation = simulationOf();
    Tick tick;
    for (int landing = 1; landing <= 3; ++landing) {
        for (int i = 0; i < 40; ++i) tick = simulation.step(touching(at(0, 0, 0.405 - 0.01 * landing * i)), kTick);
        for (int i = 0; i < 10; ++i) tick = simulation.step(touching(at(0, 0, -0.1)), kTick);
        ASSERT_EQ(tick.contact.onsets, static_cast<std::uint32_t>(landing));
        for (int i = 0; i < 40; ++i) tick = simulation.step(touching(at(0, 0, 0.405)), kTick);
        ASSERT_EQ(tick.contact.onsets, static_cast<std::uint32_t>(landing));
        if (landing > 1) {
            EXPECT_NEAR(tick.contact.impactSpeed, 10 * landing, 0.1 * landing);
        }
    }
}

TEST(HapticSimulation, ADeviceThatStartsInsideIsPushedOut) {
    HapticSimulation simulation = simulationOf();
    const Tick tick = simulation.step(touching(at(0.2, 0.1, -0.6)), kTick);
    ASSERT_TRUE(tick.contact.placed);
    EXPECT_NEAR(tick.contact.depth, 0.6, 1e-4);
    EXPECT_NEAR(tick.force.wrench.force.z(), 0.6 * kMaterials[test::kEnamel].stiffness, 1e-4);
    EXPECT_EQ(tick.contact.onsets, 1U);
}

TEST(HapticSimulation, EqualInputsGiveEqualBits) {
    for (const ContactMode mode : {ContactMode::Proxy, ContactMode::Penalty}) {
        HapticSettings settings;
        settings.mode = mode;
        HapticSimulation first = simulationOf(settings);
        HapticSimulation second = simulationOf(settings);
        int touched = 0;
        for (const OperatorInput& hand : wandering(2000)) {
            const Tick tick = first.step(hand, kTick);
            ASSERT_TRUE(equalBits(tick, second.step(hand, kTick))) << tick.time;
            touched += tick.contact.triangles > 0;
        }
        EXPECT_GT(touched, 500);
    }
}

TEST(HapticSimulation, PenaltyModePushesOutOfThePlaneToo) {
    HapticSettings settings;
    settings.mode = ContactMode::Penalty;
    HapticSimulation simulation = simulationOf(settings);
    simulation.step(touching(at(0.1, 0.2, 0.1)), kTick);
    Tick tick;
    for (int i = 0; i < 20; ++i) tick = simulation.step(touching(at(0.1, 0.2, -0.02)), kTick);
    EXPECT_TRUE(tick.contact.placed);
    EXPECT_GT(tick.contact.depth, 0);
    EXPECT_GT(tick.force.wrench.force.z(), 0);
    EXPECT_NEAR(tick.force.wrench.force.norm(), tick.contact.depth * kMaterials[test::kEnamel].stiffness, 1e-6);
    EXPECT_EQ(tick.contact.proxy.position, Vec3(tick.input.device.position + tick.contact.depth * tick.contact.normal));
}

TEST(HapticSimulation, TheBurRestsInTouchModeAndSpinsInCutMode) {
    HapticSimulation simulation = simulationOf();
    for (int i = 0; i < 500; ++i) {
        ASSERT_EQ(simulation.step({at(0, 0, 1), 1, false}, kTick).spindle.speedRpm, 0);
    }
    Tick tick;
    for (int i = 0; i < 5000; ++i) tick = simulation.step(cutting(at(0, 0, 1)), kTick);
    EXPECT_NEAR(tick.spindle.speedRpm, 400000, 400);
    EXPECT_EQ(tick.spindle.cutWork, 0);  // no work in the air
    EXPECT_EQ(tick.spindle.load, 0);
}

TEST(HapticSimulation, TheSpindleSlowsUnderLoadToWhereItsTorqueHoldsIt) {
    HapticSimulation simulation = simulationOf();
    for (int i = 0; i < 5000; ++i) simulation.step(cutting(at(0, 0, 0.1)), kTick);
    Tick tick;
    for (int i = 0; i < 5000; ++i) tick = simulation.step(cutting(at(0, 0, -1.2)), kTick);
    const double torque = 0.5 * 1.2 * kMaterials[test::kEnamel].stiffness * test::kBallRadius;
    EXPECT_NEAR(tick.spindle.load, torque, 1e-4);
    EXPECT_NEAR(tick.spindle.speedRpm, 400000 * (1 - torque / 1.4), 400);
    for (int i = 0; i < 5000; ++i) tick = simulation.step(cutting(at(0, 0, 0.1)), kTick);
    EXPECT_NEAR(tick.spindle.speedRpm, 400000, 400);
}

TEST(HapticSimulation, SumsNormalForceTimesRimTravel) {
    HapticSimulation simulation = simulationOf();
    for (int i = 0; i < 500; ++i) simulation.step(cutting(at(0, 0, 0.1)), kTick);
    double booked = 0;
    double power = 0;
    double x = 0;
    for (int i = 0; i < 400; ++i) {
        x += 0.005;
        const Tick tick = simulation.step(cutting(at(x, 0, -0.3)), kTick);
        const double normalForce = simulation.force().normalForce();
        const double powerBefore = std::exchange(power, normalForce * rimSpeed(tick.spindle.speedRpm));
        booked += (powerBefore + power) / 2 * kTick;
        ASSERT_NEAR(tick.spindle.cutWork, booked, 1e-12 * (1 + booked));
        ASSERT_NEAR(tick.spindle.removalPower, 0.5 * normalForce * rimSpeed(tick.spindle.speedRpm),
                    1e-12 * tick.spindle.removalPower);
        ASSERT_NEAR(tick.spindle.load, 0.5 * normalForce * test::kBallRadius, 1e-12 * tick.spindle.load);
        // The force contains it, beside the vibration (4 %, across the axis: the normal deviates from the axis by a few
        // hundredths).
        ASSERT_NEAR(tick.force.wrench.force.dot(tick.contact.normal), normalForce, 4e-3 * normalForce);
    }
    EXPECT_GT(booked, 0.5);
    const Tick lifted = simulation.step(cutting(at(x, 0, 0.2)), kTick);
    EXPECT_EQ(lifted.contact.triangles, 0) << "a bur that is late does not hold the hand back";
    EXPECT_EQ(lifted.force.wrench.force, Vec3::Zero());
    EXPECT_NEAR(lifted.spindle.cutWork, booked, 1e-12 * booked);
}

TEST(HapticSimulation, ABurAtRestDoesNoWork) {
    HapticSimulation simulation = simulationOf();
    simulation.step(cutting(at(0, 0, 0.1), 0), kTick);
    Tick tick;
    for (int i = 0; i < 100; ++i) tick = simulation.step(cutting(at(0, 0, -0.3), 0), kTick);
    EXPECT_GT(tick.force.wrench.force.z(), 0.2);
    EXPECT_EQ(tick.spindle.cutWork, 0);
    EXPECT_EQ(tick.spindle.load, 0);
}

TEST(HapticSimulation, AFaultyDevicePoseMakesNoForceAndHasNoLaterEffect) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const double nan = std::nan("");
    const std::vector<Pose> nowhere = {at(nan, 0, 0),
                                       at(0, kInfinity, 0),
                                       at(0, 0, -1e300),
                                       at(2e6, 0, 0),
                                       {Vec3::Zero(), Quat(nan, 0, 0, 0)},
                                       {Vec3::Zero(), Quat(0, 0, 0, 0)},
                                       {Vec3::Zero(), Quat(2, 0, 0, 0)}};
    for (const Pose& pose : nowhere) {
        HapticSimulation simulation = simulationOf();
        simulation.step(touching(at(0, 0, 0.1)), kTick);
        const Tick before = simulation.step(touching(at(0, 0, -0.2)), kTick);
        for (int i = 0; i < 3; ++i) {
            const Tick lost = simulation.step(cutting(pose), kTick);
            EXPECT_FALSE(lost.contact.placed);
            EXPECT_EQ(lost.force.wrench.force, Vec3::Zero());
            EXPECT_EQ(lost.contact.triangles, 0);
            EXPECT_EQ(lost.input.device.position, before.input.device.position);
            EXPECT_EQ(lost.contact.proxy.position, before.contact.proxy.position);
        }
        const Tick after = simulation.step(touching(at(0.3, 0, -0.2)), kTick);
        EXPECT_TRUE(after.contact.placed);
        EXPECT_NEAR(after.contact.depth, 0.2, kRounding);
        EXPECT_NEAR(after.force.wrench.force.z(), 0.2 * kMaterials[test::kEnamel].stiffness, 5 * kRounding);
        EXPECT_EQ(after.input.speed, 0);
    }
}

TEST(HapticSimulation, AFaultyFirstDevicePoseHasNoLaterEffect) {
    HapticSimulation simulation = simulationOf();
    EXPECT_FALSE(simulation.step(touching(at(std::nan(""), 0, 0)), kTick).contact.placed);
    const Tick tick = simulation.step(touching(at(0, 0, 0.5)), kTick);
    EXPECT_TRUE(tick.contact.placed);
    EXPECT_EQ(tick.input.speed, 0);
    EXPECT_EQ(tick.time, kTick);
}

TEST(HapticSimulation, ThePedalIsClampedToZeroToOne) {
    HapticSimulation simulation = simulationOf();
    const auto run = [&](double pedal) {
        Tick tick;
        for (int i = 0; i < 20; ++i) tick = simulation.step(cutting(at(0, 0, 1), pedal), kTick);
        return tick;
    };
    EXPECT_EQ(run(7).input.pedal, 1);
    EXPECT_GT(run(1).spindle.speedRpm, 0);
    EXPECT_EQ(run(-3).input.pedal, 0);
    const Tick lost = run(std::nan(""));
    EXPECT_EQ(lost.input.pedal, 0);
    EXPECT_TRUE(std::isfinite(lost.spindle.speedRpm));
}

TEST(HapticSimulation, TheMaterialIsThatOfTheSurfaceTouched) {
    for (const MaterialId material : {test::kEnamel, test::kDentin, test::kCaries}) {
        HapticSimulation simulation = simulationOf({}, test::block(material));
        simulation.step(touching(at(0, 0, 0.1)), kTick);
        for (int i = 0; i < 30; ++i) simulation.step(touching(at(0, 0, -0.1)), kTick);
        const Tick tick = simulation.step(touching(at(0, 0, -0.1)), kTick);
        EXPECT_EQ(tick.contact.material, material);
        EXPECT_NEAR(tick.force.wrench.force.z(), 0.1 * kMaterials[material].stiffness, 2 * kRounding);
    }
}

TEST(HapticSimulation, AToolWithSixDegreesOfFreedomGivesTheTorqueOfItsRotation) {
    const auto plank = std::make_shared<const ToolShape>(test::box(Vec3(-1, -0.5, 0), Vec3(1, 0.5, 6)));
    HapticSettings settings;
    settings.freedom = Freedom::TranslationAndRotation;
    settings.force.friction = 0;
    HapticSimulation simulation(plank, 1, test::block(), settings);
    const double characteristicLength = ProxySolver(plank, Freedom::TranslationAndRotation).characteristicLength();
    const double stiffness = kMaterials[test::kEnamel].stiffness;
    Tick tick;
    for (int i = 0; i <= 300; ++i) {
        const double tilt = std::min(i, 200) * 1e-4;
        const Pose hand{Vec3(0, 0, 0.1 - 0.001 * std::min(i, 200)), Quat(Eigen::AngleAxisd(tilt, Vec3::UnitY()))};
        tick = simulation.step(touching(hand), kTick);
    }
    const Vec3 centre = tick.contact.proxy * plank->centre();
    const Eigen::AngleAxisd turn(tick.contact.proxy.rotation * tick.input.device.rotation.conjugate());
    const Vec3 shift = centre - tick.input.device * plank->centre();
    ASSERT_GT(turn.angle(), 0.005);  // it rests on the block, in part
    EXPECT_NEAR((tick.force.wrench.force - stiffness * shift).norm(), 0, 1e-4);
    const Vec3 aboutCentre =
        tick.force.wrench.torque - (centre - tick.contact.proxy.position).cross(tick.force.wrench.force);
    const Vec3 expected = stiffness * characteristicLength * characteristicLength * turn.angle() * turn.axis();
    EXPECT_NEAR((aboutCentre - expected).norm(), 0, 1e-3 * expected.norm());
}

}  // namespace
}  // namespace tactooth
