// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/device_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numbers>

#include "haptics/haptic_simulation.h"
#include "support/materials.h"
#include "support/servo_tick.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using test::kTick;
constexpr double kMaxStep = 0.3;  // N in a millisecond
constexpr unsigned kSwap = 1, kCut = 2, kClutch = 4;
constexpr double kWide = 5;        // mm, half the block
constexpr double kPressed = -1.2;  // mm: 1.2 N on enamel of 1 N/mm

Pose at(double x, double y, double z) { return {Vec3(x, y, z), Quat::Identity()}; }

std::shared_ptr<const Surface> block() {
    const std::vector<SurfaceTag> tags(12, static_cast<SurfaceTag>(test::kEnamel));
    auto surface = std::make_shared<Surface>();
    surface->base =
        std::make_shared<const SurfacePart>(test::box(Vec3(-kWide, -kWide, -kWide), Vec3(kWide, kWide, 0)), tags);
    return surface;
}

/// A device whose pose the test sets.
class StillDevice final : public HapticDevice {
public:
    explicit StillDevice(const Pose& hand) {
        sample.hand = hand;
        info_.rendersForce = true;
        info_.limits.force = 7.9;
        info_.stiffness = 1;
    }
    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override { return {}; }
    void close() override {}
    [[nodiscard]] DeviceSample read(double) override { return sample; }
    void write(const SafeWrench& wrench) override {
        worstStep = std::max(worstStep, (wrench.force() - force).norm());
        force = wrench.force();
    }

    void setWorkspace(const Vec3& size, const Vec3& workspaceCentre) {
        info_.workspace = size;
        info_.workspaceCentre = workspaceCentre;
    }

    DeviceSample sample;
    Vec3 force = Vec3::Zero();
    double worstStep = 0;  // N between two ticks

private:
    DeviceInfo info_;
};

/// Two devices over a block of enamel, tick by tick, without a clock.
class Rig {
public:
    explicit Rig(bool hasSecond = true, const std::optional<DeviceRegistration>& registration = {})
        : hands(first, hasSecond ? &second : nullptr, registration),
          simulation(ball(), 0.5, block(), HapticSettings()) {
        controls.buttons.clutch = 2;
    }

    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            hands.read(kTick, controls);
            simulation.force().setMaxStiffness(hands.maxStiffness());
            tick = simulation.step({hands.turbine(), hands.pedal(), cuts != hands.cutToggled()}, kTick);
            hands.write(tick, enabled, kTick);
        }
    }
    /// A short press of a button.
    void click(StillDevice& device, unsigned button) {
        device.sample.buttons |= button;
        run(1);
        device.sample.buttons &= ~button;
    }
    /// Moves the device down onto the block and presses until the force has its full size.
    void press(StillDevice& device) {
        device.sample.hand.position.z() = 0.5;
        run(20);
        for (double z = 0.5; z > kPressed; z -= 0.01) {
            device.sample.hand.position.z() = z;
            run(1);
        }
        run(1000);
    }

    /// Moves the device up, or down, at 0.5 m/s.
    void lift(StillDevice& device, double millimetres) {
        constexpr int kTicks = 6;
        for (int i = 0; i < kTicks; ++i) {
            device.sample.hand.position.z() += millimetres / kTicks;
            run(1);
        }
    }

    StillDevice first{at(0, 0, 0.5)};
    StillDevice second{at(30, 40, 50)};
    DeviceControls controls;
    DeviceSet hands;
    HapticSimulation simulation;
    Tick tick;
    bool cuts = false;
    bool enabled = true;
    double scale = 1;     // of the force
    double spring = 0.2;  // N/mm

private:
    static std::shared_ptr<const ToolShape> ball() {
        return std::make_shared<const ToolShape>(test::sphere(Vec3(0, 0, 0.5), 0.5, 24, 12));
    }
};

TEST(DeviceSet, EachOfTwoMovesItsOwnInstrument) {
    Rig rig;
    rig.run(1);
    EXPECT_EQ(rig.hands.turbine().position, Vec3(0, 0, 0.5));
    EXPECT_EQ(rig.hands.mirror().position, Vec3::Zero()) << "it is where it was parked";
    rig.first.sample.hand.position += Vec3(1, 0, 0);
    rig.second.sample.hand.position += Vec3(0, 2, 0);
    rig.run(1);
    EXPECT_EQ(rig.hands.turbine().position, Vec3(1, 0, 0.5));
    EXPECT_EQ(rig.hands.mirror().position, Vec3(0, 2, 0));
}

TEST(DeviceSet, ReportsTheWorkspaceLimitOfEitherUnlessTheClutchIsHeld) {
    Rig rig;
    rig.second.setWorkspace(Vec3(100, 100, 100), Vec3(30, 40, 50));
    const auto isAtWorkspaceLimit = [&rig](double x) {
        rig.second.sample.hand.position.x() = x;
        rig.run(1);
        return rig.hands.isAtWorkspaceLimit();
    };
    EXPECT_FALSE(isAtWorkspaceLimit(77));
    EXPECT_TRUE(isAtWorkspaceLimit(79));
    EXPECT_TRUE(isAtWorkspaceLimit(77)) << "it has to come back a little, so that a trembling hand is reported once";
    EXPECT_FALSE(isAtWorkspaceLimit(70));
    EXPECT_TRUE(isAtWorkspaceLimit(79));
    rig.second.sample.buttons = kClutch;
    EXPECT_FALSE(isAtWorkspaceLimit(79));
    rig.second.sample.buttons = 0;
    EXPECT_TRUE(isAtWorkspaceLimit(79));
    rig.controls.clutch = true;
    EXPECT_FALSE(isAtWorkspaceLimit(79));
}

TEST(DeviceSet, ARegistrationRotatesTheMirrorAsItRotatesTheTool) {
    const Quat quarter(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()));
    Rig rig(true, DeviceRegistration{at(0, 0, 5), quarter});
    rig.run(1);
    rig.first.sample.hand.position += Vec3(1, 0, 0);
    rig.second.sample.hand.position += Vec3(1, 0, 0);
    rig.run(1);
    EXPECT_LT((rig.hands.turbine().position - Vec3(0, 1, 5)).norm(), 1e-12);
    EXPECT_LT((rig.hands.mirror().position - Vec3(0, 1, 0)).norm(), 1e-12);
}

/// A floor `depth` below the top of the block.
DepthControl floorAt(double depth) {
    DepthControl control;
    control.setSurface(block()->base);
    control.setDepth(depth);
    return control;
}

TEST(DeviceSet, ADepthStopHoldsTheTurbineAndPushesTheDeviceBack) {
    constexpr double kDepth = 0.3;  // mm
    const DepthControl floor = floorAt(kDepth);
    Rig rig;
    rig.press(rig.first);
    const double byTooth = rig.first.force.z();
    rig.lift(rig.first, 3);
    rig.run(100);
    rig.controls.depthStop = &floor;
    rig.press(rig.first);
    // The block is not cut: the bur stays above the floor, and is pressed a little beyond it.
    const double held = -rig.hands.turbine().position.z();
    EXPECT_GE(held, kDepth - 1e-6);
    EXPECT_LT(held, kDepth + 0.1);
    // The springs of tooth and stop are in a row: each is pressed by its part of the way.
    const double wanted = byTooth * held / -kPressed + DepthStop::kStiffness * (-kPressed - held);
    EXPECT_NEAR(rig.first.force.z(), wanted, 0.05);
    EXPECT_LE(rig.first.worstStep, kMaxStep + 1e-9);
    EXPECT_EQ(rig.second.force, Vec3::Zero()) << "the mirror is free";
}

TEST(DeviceSet, ADepthStopInFreeSpacePushesNothing) {
    const DepthControl floor = floorAt(1);
    Rig rig;
    rig.controls.depthStop = &floor;
    rig.first.sample.hand.position.z() = 2;
    rig.run(200);
    EXPECT_EQ(rig.first.force, Vec3::Zero());
    EXPECT_EQ(rig.hands.turbine().position.z(), 2);
}

TEST(DeviceSet, ASwapAtTheDepthStopMovesNothing) {
    const DepthControl floor = floorAt(0.3);
    Rig rig;
    rig.controls.depthStop = &floor;
    rig.press(rig.first);
    const Vec3 held = rig.hands.turbine().position;
    rig.click(rig.first, kSwap);
    EXPECT_LT((rig.hands.turbine().position - held).norm(), 0.01);
    rig.run(200);
    EXPECT_LT((rig.hands.turbine().position - held).norm(), 0.1) << "no more than the press beyond the floor";
    EXPECT_EQ(rig.second.force, Vec3::Zero()) << "not before it has been in free space";
}

TEST(DeviceSet, ALostDeviceGetsNoForceOfTheDepthStop) {
    const DepthControl floor = floorAt(0.3);
    Rig rig;
    rig.controls.depthStop = &floor;
    rig.press(rig.first);
    ASSERT_GT(rig.first.force.z(), 0.5);
    rig.first.sample.connected = false;
    rig.run(1);
    EXPECT_EQ(rig.first.force, Vec3::Zero());
}

/// A guide that wants nothing of the block cut.
WallGuide guideAtTheBlock() {
    auto walls =
        std::make_shared<const DistanceGrid>(guideWalls(*block()->base, Box3(Vec3(-1, -1, -2), Vec3(1, 1, 0))));
    return {std::move(walls), RevolutionEnvelope::make(test::sphere(Vec3(0, 0, 0.5), 0.5, 48, 24)).value()};
}

TEST(DeviceSet, AGuideAddsItsSpringAndMovesNothing) {
    const WallGuide guide = guideAtTheBlock();
    Rig rig;
    rig.press(rig.first);
    const double byTooth = rig.first.force.z();
    const Vec3 held = rig.hands.turbine().position;
    rig.controls.guide = &guide;
    rig.run(500);
    EXPECT_EQ(rig.hands.turbine().position, held) << "what is simulated is the tool of the hand";
    EXPECT_NEAR(rig.first.force.z() - byTooth, WallGuide::kMostForce, 0.1);
    EXPECT_LE(rig.first.worstStep, kMaxStep + 1e-9);
    EXPECT_EQ(rig.second.force, Vec3::Zero()) << "the mirror is free";
    rig.controls.guide = nullptr;
    rig.run(500);
    EXPECT_NEAR(rig.first.force.z(), byTooth, 0.05);
}

TEST(DeviceSet, ALostDeviceGetsNoForceOfTheGuide) {
    const WallGuide guide = guideAtTheBlock();
    Rig rig;
    rig.controls.guide = &guide;
    rig.press(rig.first);
    ASSERT_GT(rig.first.force.z(), 0.5);
    rig.first.sample.connected = false;
    rig.run(1);
    EXPECT_EQ(rig.first.force, Vec3::Zero());
}

TEST(DeviceSet, ASwapMovesNothingAndExchangesWhatTheyHold) {
    Rig rig;
    rig.run(1);
    rig.second.sample.hand.position += Vec3(0, 2, 0);
    rig.run(1);
    for (StillDevice* const presser : {&rig.first, &rig.second, &rig.second, &rig.first}) {
        const Pose turbine = rig.hands.turbine();
        const Pose mirror = rig.hands.mirror();
        rig.click(*presser, kSwap);
        EXPECT_LT((rig.hands.turbine().position - turbine.position).norm(), 1e-12);
        EXPECT_LT((rig.hands.mirror().position - mirror.position).norm(), 1e-12);
        rig.run(5);
        EXPECT_LT((rig.hands.turbine().position - turbine.position).norm(), 1e-12);
    }
    rig.click(rig.first, kSwap);
    const Vec3 turbine = rig.hands.turbine().position;
    const Vec3 mirror = rig.hands.mirror().position;
    rig.second.sample.hand.position += Vec3(0, 0, 3);
    rig.first.sample.hand.position += Vec3(4, 0, 0);
    rig.run(1);
    EXPECT_LT((rig.hands.turbine().position - turbine - Vec3(0, 0, 3)).norm(), 1e-12);
    EXPECT_LT((rig.hands.mirror().position - mirror - Vec3(4, 0, 0)).norm(), 1e-12);
}

TEST(DeviceSet, ASingleHandLaysTheTurbineDownAndTakesItUpAgainWithoutAJump) {
    Rig rig(false);
    rig.run(1);
    rig.click(rig.first, kSwap);
    rig.first.sample.hand.position += Vec3(1, 2, 3);
    rig.run(1);
    EXPECT_EQ(rig.hands.turbine().position, Vec3(0, 0, 0.5));
    EXPECT_LT((rig.hands.mirror().position - Vec3(1, 2, 3)).norm(), 1e-12);
    rig.click(rig.first, kSwap);
    EXPECT_LT((rig.hands.turbine().position - Vec3(0, 0, 0.5)).norm(), 1e-12);
    rig.first.sample.hand.position += Vec3(0.5, 0, 0);
    rig.run(1);
    EXPECT_LT((rig.hands.turbine().position - Vec3(0.5, 0, 0.5)).norm(), 1e-12);
}

TEST(DeviceSet, ASwapMidPressFadesTheForceAndTheOtherHandGetsNoneBeforeTheBurIsFree) {
    Rig rig;
    rig.press(rig.first);
    ASSERT_GT(rig.first.force.norm(), 1);
    rig.click(rig.second, kSwap);
    rig.run(50);
    EXPECT_EQ(rig.first.force, Vec3::Zero());
    EXPECT_EQ(rig.second.force, Vec3::Zero()) << "the bur is deep in the block, and nobody is kicked";
    EXPECT_LE(rig.first.worstStep, kMaxStep + 1e-9);
    rig.lift(rig.second, 3);  // out of the block
    rig.lift(rig.second, -3);
    rig.run(1000);
    EXPECT_GT(rig.second.force.norm(), 1);
    EXPECT_EQ(rig.first.force, Vec3::Zero());
    EXPECT_LE(rig.second.worstStep, kMaxStep + 1e-9);
}

TEST(DeviceSet, TheButtonOfEitherTurnsTouchIntoCut) {
    Rig rig;
    rig.run(1);
    EXPECT_FALSE(rig.hands.cutToggled());
    rig.click(rig.second, kCut);
    EXPECT_TRUE(rig.hands.cutToggled());
    rig.click(rig.first, kCut);
    EXPECT_FALSE(rig.hands.cutToggled());
}

TEST(DeviceSet, TheDeeperFootCounts) {
    Rig rig;
    rig.first.sample.pedal = 0.2;
    rig.second.sample.pedal = 0.7;
    rig.run(1);
    EXPECT_EQ(rig.hands.pedal(), 0.7);
    rig.second.sample.connected = false;
    rig.run(1);
    EXPECT_EQ(rig.hands.pedal(), 0.2);
}

TEST(DeviceSet, ALostDeviceDropsItsForceAtOnceAndTheOtherHandGoesOn) {
    Rig rig;
    rig.press(rig.first);
    rig.first.sample.connected = false;
    rig.second.sample.hand.position += Vec3(0, 2, 0);
    rig.run(1);
    EXPECT_EQ(rig.first.force, Vec3::Zero());
    EXPECT_LT((rig.hands.mirror().position - Vec3(0, 2, 0)).norm(), 1e-12);
    EXPECT_EQ(rig.hands.forceState(), ForceState::Fault);
}

TEST(DeviceSet, ABurWhoseDeviceIsLostStaysAtTheSurfaceAndCutsNoMore) {
    Rig rig;
    rig.first.sample.pedal = 1;
    rig.second.sample.pedal = 1;
    rig.cuts = true;
    rig.press(rig.first);
    ASSERT_GT(rig.tick.contact.depth, 0.5);
    rig.first.sample.connected = false;
    rig.run(2);
    const double work = rig.tick.spindle.cutWork;
    rig.run(500);
    EXPECT_LT(rig.tick.contact.depth, 1e-3);
    EXPECT_NEAR(rig.tick.spindle.cutWork, work, 1e-6);
}

TEST(DeviceSet, TheLossOfTheSecondDeviceLeavesTheForceOfTheFirst) {
    Rig rig;
    rig.press(rig.first);
    const Vec3 force = rig.first.force;
    rig.second.sample.connected = false;
    rig.second.sample.hand.position.setConstant(std::numeric_limits<double>::quiet_NaN());
    rig.run(100);
    EXPECT_LT((rig.first.force - force).norm(), 1e-6);
    EXPECT_TRUE(rig.hands.mirror().position.allFinite());
}

/// A setting that is switched while the device presses.
struct Switch {
    const char* name;
    bool changesForce;
    std::function<void(Rig&)> flip;
};

class SwitchMidPress : public ::testing::TestWithParam<Switch> {};

TEST_P(SwitchMidPress, ChangesTheForceByNoMoreThanThreeTenthsOfANewtonAMillisecond) {
    Rig rig;
    rig.first.sample.pedal = 1;
    rig.press(rig.first);
    ASSERT_GT(rig.first.force.norm(), 1);
    rig.first.worstStep = 0;
    for (int i = 0; i < 6; ++i) {
        GetParam().flip(rig);
        rig.run(7 + 40 * i);
    }
    EXPECT_LE(rig.first.worstStep, kMaxStep + 1e-9);
    if (GetParam().changesForce) {
        EXPECT_GT(rig.first.worstStep, 0.01);
    }
    EXPECT_LE(rig.second.worstStep, kMaxStep + 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    All, SwitchMidPress,
    ::testing::Values(
        Switch{"TouchAndCut", true, [](Rig& rig) { rig.cuts = !rig.cuts; }},
        Switch{"CutByButton", true, [](Rig& rig) { rig.click(rig.first, kCut); }},
        Switch{"TurbineAndMirror", true, [](Rig& rig) { rig.click(rig.first, kSwap); }},
        Switch{"Clutch", true, [](Rig& rig) { rig.first.sample.buttons ^= kClutch; }},
        Switch{"MotionScaling", false, [](Rig& rig) { rig.controls.motionScaling = 4 - rig.controls.motionScaling; }},
        Switch{"ForceOff", true, [](Rig& rig) { rig.enabled = !rig.enabled; }},
        Switch{"ForceScale", true, [](Rig& rig) { rig.simulation.force().setScale(rig.scale = 1.3 - rig.scale); }},
        Switch{"Spring", true,
               [](Rig& rig) {
                   rig.simulation.force().setOverrides({rig.spring = 3.2 - rig.spring, {}, {}});
               }}),
    [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace tactooth
