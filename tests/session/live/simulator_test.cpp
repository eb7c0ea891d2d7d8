// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/live/simulator.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "bench_scene.h"
#include "collision/bvh/closest_point.h"
#include "devices/simulated/null_device.h"
#include "devices/simulated/scripted_device.h"
#include "support/materials.h"
#include "support/sanitizer.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;
using test::at;
using Clock = std::chrono::steady_clock;

/// A simulated device. The test reads its pose, connection and force while the servo thread runs.
class SpyDevice final : public HapticDevice {
public:
    explicit SpyDevice(std::vector<DeviceKeyframe> script) : script_(std::move(script)) { info_ = script_.info(); }
    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override { return script_.open(); }
    void close() override {}
    [[nodiscard]] DeviceSample read(double elapsed) override {
        elapsed_ = elapsed;
        DeviceSample sample = script_.read(elapsed);
        sample.connected = connected_;
        if (!connected_) sample.hand.position.setConstant(std::nan(""));
        return sample;
    }
    void write(const SafeWrench& wrench) override {
        const double force = wrench.force().norm();
        const double step = (wrench.force() - lastForce_).norm();
        const bool afterStall = elapsed_ > info_.limits.tickTimeout && force == 0;
        if (step > info_.limits.slew * elapsed_ + 1e-9 && !afterStall) jumped_ = true;
        lastForce_ = wrench.force();
        forceBefore_ = force_.load();
        force_ = force;
        if (!(force <= info_.limits.force + 1e-9) || !wrench.torque().isZero(0)) tooStrong_ = true;
        if (force > strongest_) strongest_ = force;
    }

    void plugIn(bool connected) { connected_ = connected; }
    [[nodiscard]] double force() const { return force_; }
    [[nodiscard]] double forceBefore() const { return forceBefore_; }
    [[nodiscard]] double strongest() const { return strongest_; }
    [[nodiscard]] bool wasForceTooLarge() const { return tooStrong_; }
    /// Whether the force has ever changed by more than 0.3 N a millisecond, but for a stall of the machine.
    [[nodiscard]] bool hasJumped() const { return jumped_; }

private:
    ScriptedDevice script_;
    DeviceInfo info_;
    std::atomic<bool> connected_{true};
    std::atomic<double> force_{0};
    std::atomic<double> forceBefore_{0};
    std::atomic<double> strongest_{0};
    std::atomic<bool> tooStrong_{false};
    std::atomic<bool> jumped_{false};
    double elapsed_ = 0;  // of the servo's
    Vec3 lastForce_ = Vec3::Zero();
};

DeviceKeyframe moment(double time, const Pose& hand, double pedal) { return {time, {hand, pedal, 0, true}}; }

/// Comes down on the block, then strokes over it, half a millimetre deep.
std::vector<DeviceKeyframe> stroking() {
    std::vector<DeviceKeyframe> script = {moment(0, at(-0.5, 0, 0.3), 1), moment(0.3, at(-0.5, 0, -0.5), 1)};
    for (int i = 1; i <= 20; ++i) script.push_back(moment(0.3 + 0.3 * i, at(i % 2 ? 0.5 : -0.5, 0, -0.5), 1));
    return script;
}

std::vector<DeviceKeyframe> resting(double z) { return {moment(0, at(0, 0, z), 1)}; }

/// Comes down on the block, rests there and lifts off again, over and over: after a stall of the machine the force
/// waits until the bur was free.
std::vector<DeviceKeyframe> dipping() {
    std::vector<DeviceKeyframe> script;
    for (int i = 0; i < 60; ++i) {
        const double start = 0.8 * i;
        script.push_back(moment(start, at(0, 0, 0.3), 1));
        script.push_back(moment(start + 0.1, at(0, 0, -0.5), 1));
        script.push_back(moment(start + 0.7, at(0, 0, -0.5), 1));
    }
    return script;
}

SimulatorControls cutting() {
    SimulatorControls controls;
    controls.cutting = true;
    return controls;
}

/// Waits until a condition holds; the machine may be busy.
template <class Condition>
bool soon(const Condition& condition, std::chrono::seconds limit = 20s) {
    const auto end = Clock::now() + limit;
    while (!condition()) {
        if (Clock::now() > end) return false;
        std::this_thread::sleep_for(2ms);
    }
    return true;
}

TEST(Simulator, CutsABlockLive) {
    const auto piece = test::blockOnTheBench();
    SpyDevice device(stroking());
    std::atomic<std::uint64_t> heard{0};
    std::vector<Tick> ticks;
    double removedOnline = 0;
    {
        Simulator simulator(piece, test::flatBur(), HapticSettings(), device, [&](const Tick&) { ++heard; });
        simulator.setControls(cutting());
        const auto end = Clock::now() + 2s;
        while (Clock::now() < end) {
            std::this_thread::sleep_for(10ms);
            simulator.fetchTicks(ticks);
        }
        EXPECT_TRUE(soon([&] { return simulator.surfaceUpdates() > 3 && total(simulator.removed()) > 0.01; }));
        EXPECT_GT(simulator.surface()->revision, 3U);
        EXPECT_GT(simulator.timing().ticks, 100U);
        removedOnline = total(simulator.removed());
    }
    // A voxel's share falls a little where the last sweep turned the wall's normal: never by as much as the voxel.
    EXPECT_GE(total(piece->removed()), removedOnline - std::pow(test::kVoxel, 3));
    EXPECT_GT(heard, 100U);
    EXPECT_FALSE(device.wasForceTooLarge());
    EXPECT_GT(device.strongest(), 0.05);
    EXPECT_EQ(device.force(), 0);  // the last force sent to a device is zero
    ASSERT_GT(ticks.size(), 100U);
    for (std::size_t i = 1; i < ticks.size(); ++i) ASSERT_GE(ticks[i].time, ticks[i - 1].time);
    EXPECT_GT(ticks.back().speedRpm, 10000);
}

TEST(Simulator, InTouchModeNothingIsCut) {
    const auto piece = test::blockOnTheBench();
    SpyDevice device(stroking());
    {
        Simulator simulator(piece, test::flatBur(), HapticSettings(), device, {});
        EXPECT_TRUE(soon([&] { return device.strongest() > 0.05; }));
    }
    EXPECT_EQ(total(piece->removed()), 0);
}

TEST(Simulator, ForceSwitchedOffLeavesTheDeviceLimp) {
    SpyDevice device(dipping());
    Simulator simulator(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {});
    EXPECT_TRUE(soon([&] { return device.force() > 0.01; }));
    SimulatorControls off;
    off.forceEnabled = false;
    simulator.setControls(off);
    EXPECT_TRUE(soon([&] { return device.force() == 0; }));
    const auto ticks = simulator.timing().ticks.load();
    EXPECT_TRUE(soon([&] { return simulator.timing().ticks > ticks + 20; }));
    EXPECT_EQ(device.force(), 0);
}

TEST(Simulator, StartingInsideTheToothGivesNoForce) {
    SpyDevice device(resting(-0.5));
    Simulator simulator(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {});
    EXPECT_TRUE(soon([&] { return simulator.forceState() == ForceState::AwaitsFreeSpace; }))
        << "a place was found for it";
    const auto ticks = simulator.timing().ticks.load();
    EXPECT_TRUE(soon([&] { return simulator.timing().ticks > ticks + 300; }));
    EXPECT_EQ(device.strongest(), 0);
    EXPECT_EQ(simulator.forceState(), ForceState::AwaitsFreeSpace);
}

TEST(Simulator, EndingMidPressFadesTheForceOutFirst) {
    for (int i = 0; i < 5; ++i) {
        SpyDevice device(dipping());
        {
            Simulator simulator(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {});
            EXPECT_TRUE(soon([&] { return device.force() > 0.05; }));
        }
        EXPECT_EQ(device.force(), 0);
        EXPECT_EQ(device.forceBefore(), 0) << "the last zero came after others";
    }
}

Instrument thickBur() {
    const TriangleMesh mesh = test::cylinder(Vec3::Zero(), 1.5 * test::kBurRadius, 4, 32);
    return {std::make_shared<const ToolShape>(mesh), {*RevolutionEnvelope::make(mesh), 1}};
}

/// As the window does for another bur, tooth or drive: one simulator ends, and the next begins with the same device.
TEST(Simulator, AnotherBurToothOrDriveMidPressChangesTheForceGently) {
    SpyDevice device(dipping());
    auto piece = test::blockOnTheBench();
    Instrument bur = test::flatBur();
    HapticSettings settings;
    // A tick that takes longer than the device's stall time makes no force, and a sanitizer makes it ten times slower.
    if (test::isSanitized()) settings.tickBudget = kTickBudget / 10;
    const std::function<void()> changes[] = {[] {}, [&] { piece = test::blockOnTheBench(); }, [&] { bur = thickBur(); },
                                             [&] { settings.spindle = spindlePresets().back(); }};
    for (const auto& change : changes) {
        change();
        Simulator simulator(piece, bur, settings, device, {});
        simulator.setControls(cutting());
        EXPECT_TRUE(soon([&] { return device.force() > 0.05; }));
    }
    EXPECT_EQ(device.force(), 0);
    EXPECT_FALSE(device.hasJumped());
}

TEST(Simulator, TwoDevicesMoveTurbineAndMirror) {
    SpyDevice first(dipping());
    SpyDevice second({moment(0, at(10, 20, 30), 0), moment(0.2, at(10, 20, 30), 0), moment(0.3, at(12, 20, 30), 0)});
    Simulator simulator(test::blockOnTheBench(), test::flatBur(), HapticSettings(), first, {}, 1000, {}, &second);
    EXPECT_TRUE(soon([&] { return std::abs(simulator.mirrorMotion().position.x() - 2) < 1e-9; }));
    EXPECT_TRUE(soon([&] { return first.force() > 0.01; }));
    EXPECT_EQ(second.strongest(), 0);
}

TEST(Simulator, WhatWasCutIsKeptWhenTheDeviceIsLost) {
    SpyDevice device(stroking());
    Simulator simulator(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {});
    simulator.setControls(cutting());
    ASSERT_TRUE(soon([&] { return total(simulator.removed()) > 0.01; }));
    device.plugIn(false);
    ASSERT_TRUE(soon([&] { return device.force() == 0; }));
    std::this_thread::sleep_for(100ms);  // what was under way is cut
    const double kept = total(simulator.removed());
    EXPECT_GT(kept, 0.01);
    device.plugIn(true);
    EXPECT_TRUE(soon([&] { return total(simulator.removed()) > 1.2 * kept; })) << "and the session goes on";
}

TEST(Simulator, ARegisteredDeviceStartsWhereTheToolIsAndMovesItScaled) {
    SpyDevice device(
        {moment(0, at(100, 50, -30), 0), moment(0.2, at(100, 50, -30), 0), moment(0.3, at(103, 50, -30), 0)});
    std::vector<Tick> ticks;
    const DeviceRegistration registration{at(1, 2, 5), Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()))};
    Simulator simulator(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {}, 1000, registration);
    SimulatorControls controls;
    controls.motionScaling = 3;
    simulator.setControls(controls);
    EXPECT_TRUE(soon([&] {
        simulator.fetchTicks(ticks);
        return !ticks.empty() && (ticks.back().hand.position - Vec3(1, 3, 5)).norm() < 1e-9;
    }));
    EXPECT_LT((ticks.front().hand.position - Vec3(1, 2, 5)).norm(), 1e-9);
}

TEST(Simulator, AHandWithAPlaceOfItsOwnIsFineFromTheFirstTickOn) {
    SpyDevice device({moment(0, at(103, 50, -30), 0)});
    std::vector<Tick> ticks;
    const DeviceRegistration registration{at(1, 2, 5), Quat::Identity(), Vec3(100, 50, -30)};
    Simulator simulator(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {}, 1000, registration,
                        nullptr, 3);
    EXPECT_TRUE(soon([&] {
        simulator.fetchTicks(ticks);
        return ticks.size() > 10;
    }));
    for (const Tick& tick : ticks) EXPECT_LT((tick.hand.position - Vec3(2, 2, 5)).norm(), 1e-9);
}

TEST(Simulator, AButtonOfTheDeviceTurnsTouchIntoCut) {
    std::vector<DeviceKeyframe> script = {moment(0, at(0, 0, 3), 1), moment(0.3, at(0, 0, 3), 1),
                                          moment(0.4, at(0, 0, 3), 1)};
    script[1].sample.buttons = 2;
    SpyDevice device(script);
    std::atomic<bool> cutting{false};
    Simulator simulator(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device,
                        [&](const Tick& tick) { cutting = tick.cutting; });
    EXPECT_TRUE(soon([&] { return cutting.load(); }));
}

TEST(Simulator, AButtonHandsOverToTheMirrorWhileTheToolStays) {
    std::vector<DeviceKeyframe> script = {moment(0, at(0, 0, 3), 1), moment(0.3, at(0, 0, 3), 1),
                                          moment(0.4, at(0, 0, 3), 1), moment(0.6, at(4, 0, 3), 1)};
    script[1].sample.buttons = 1;
    SpyDevice device(script);
    std::vector<Tick> ticks;
    Simulator simulator(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {});
    EXPECT_TRUE(soon([&] { return std::abs(simulator.mirrorMotion().position.x() - 4) < 1e-9; }));
    simulator.fetchTicks(ticks);
    EXPECT_EQ(ticks.back().hand.position, Vec3(0, 0, 3));
}

TEST(Simulator, ALostDeviceGetsNoForceAndComesBackWithARamp) {
    SpyDevice device(dipping());
    Simulator simulator(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {});
    EXPECT_TRUE(soon([&] { return device.force() > 0.01; }));
    device.plugIn(false);
    EXPECT_TRUE(soon([&] { return device.force() == 0; }));
    const auto ticks = simulator.timing().ticks.load();
    EXPECT_TRUE(soon([&] { return simulator.timing().ticks > ticks + 20; }));
    EXPECT_EQ(device.force(), 0);
    device.plugIn(true);
    EXPECT_TRUE(soon([&] { return device.force() > 0.01; }));
    EXPECT_FALSE(device.wasForceTooLarge());
}

TEST(Simulator, ADeviceThatIsLostFromTheStartIsNoHand) {
    SpyDevice device(resting(-0.5));
    device.plugIn(false);
    std::atomic<bool> placed{false};
    Simulator simulator(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device,
                        [&](const Tick& tick) { placed = placed || tick.placed; });
    EXPECT_TRUE(soon([&] { return simulator.timing().ticks > 30; }));
    EXPECT_FALSE(placed);
    EXPECT_EQ(device.strongest(), 0);
}

TEST(Simulator, TheForceOverridesOfTheSettingsHoldUntilTheControlsSayOtherwise) {
    HapticSettings soft;
    soft.force.stiffness = 0.0;
    soft.force.damping = 0.0;
    SpyDevice device(dipping());
    Simulator simulator(test::blockOnTheBench(), test::flatBur(), soft, device, {});
    EXPECT_TRUE(soon([&] { return simulator.timing().ticks > 100; }));
    EXPECT_EQ(device.strongest(), 0);
    simulator.setControls({});
    EXPECT_TRUE(soon([&] { return device.strongest() > 0.01; }));
}

TEST(Simulator, TheLargerOfBothPedalsCounts) {
    SpyDevice device({moment(0, at(0, 0, 1), 0.25)});
    std::atomic<double> pedal{-1};
    Simulator simulator(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device,
                        [&](const Tick& tick) { pedal = tick.pedal; });
    EXPECT_TRUE(soon([&] { return pedal == 0.25; }));
    SimulatorControls controls;
    controls.pedal = 0.75;
    simulator.setControls(controls);
    EXPECT_TRUE(soon([&] { return pedal == 0.75; }));
}

TEST(Simulator, AResetPutsTheToothBackWhileItRuns) {
    const auto piece = test::blockOnTheBench(test::kCaries);
    SpyDevice device(stroking());
    Simulator simulator(piece, test::flatBur(), HapticSettings(), device, {});
    simulator.setControls(cutting());
    ASSERT_TRUE(soon([&] { return total(simulator.removed()) > 0.01; }));
    simulator.setControls({});
    std::this_thread::sleep_for(50ms);
    simulator.request(Edit::Reset);
    EXPECT_TRUE(soon([&] { return total(simulator.removed()) == 0; }));
    EXPECT_TRUE(simulator.surface()->patches.empty());
}

TEST(Simulator, WhatIsLooseFallsWhileTheBurIsInTheAir) {
    const auto piece = test::blockOnTheBench();
    test::cutARidgeOff(*piece);
    const double ground = total(piece->removed());
    SpyDevice device({moment(0, at(0, 0, -0.99), 0), moment(0.5, at(0, 0, -1.05), 0), moment(1, at(0, 0, 1), 0)});
    Simulator simulator(piece, test::flatBur(), HapticSettings(), device, {});
    EXPECT_TRUE(soon([&] { return simulator.loss().pieces == 1; }));
    EXPECT_GT(total(simulator.removed()), ground + 1);
    EXPECT_FALSE(contains(*simulator.surface(), Vec3(0, 1, -0.2)));
}

TEST(Simulator, UndoTakesBackTheCutsSinceTheBurWasLiftedWhileItRuns) {
    const auto piece = test::blockOnTheBench(test::kCaries);
    // Two cuts, with the bur in the air for 0.8 s between them, and then a rest in the air.
    SpyDevice device({moment(0, at(-0.5, 0, 0.3), 1), moment(0.3, at(-0.5, 0, -0.3), 1),
                      moment(0.6, at(-0.5, 0, 0.3), 1), moment(1.4, at(0.5, 0, 0.3), 1),
                      moment(1.7, at(0.5, 0, -0.4), 1), moment(2.0, at(0.5, 0, 0.5), 1)});
    Simulator simulator(piece, test::flatBur(), HapticSettings(), device, {});
    simulator.setControls(cutting());
    ASSERT_TRUE(soon([&] { return simulator.surface()->patches.empty() == false; }));
    std::this_thread::sleep_for(2500ms);
    const double both = total(simulator.removed());
    simulator.request(Edit::Undo);
    ASSERT_TRUE(soon([&] { return total(simulator.removed()) < both; }));
    const double one = total(simulator.removed());
    EXPECT_GT(one, 0.1 * both);
    simulator.request(Edit::Undo);
    EXPECT_TRUE(soon([&] { return total(simulator.removed()) == 0; }));
    simulator.request(Edit::Undo);
    std::this_thread::sleep_for(50ms);
    EXPECT_EQ(total(simulator.removed()), 0);
    EXPECT_EQ(visibleMesh(*simulator.surface()).mesh.triangles.size(), 12U) << "the block as it came";
}

TEST(Simulator, TheToothCanBeSavedWhileItIsCut) {
    const auto piece = test::blockOnTheBench(test::kCaries);
    SpyDevice device(stroking());
    Simulator simulator(piece, test::flatBur(), HapticSettings(), device, {});
    simulator.setControls(cutting());
    ASSERT_TRUE(soon([&] { return total(simulator.removed()) > 0.01; }));
    const auto saved = parseSavedTooth(simulator.toothFile({}), "saved");
    ASSERT_TRUE(saved) << saved.error().message();
    EXPECT_GT(saved->removed[static_cast<std::size_t>(test::kCaries)], 0.01);
    EXPECT_FALSE(saved->cuts.empty());
}

TEST(Simulator, ACutModelGoesOnFromOneSimulatorToTheNext) {
    const auto piece = test::blockOnTheBench(test::kCaries);
    for (int round = 0; round < 3; ++round) {
        const double before = total(piece->removed());
        SpyDevice device(stroking());
        Simulator simulator(piece, test::flatBur(), HapticSettings(), device, {});
        EXPECT_EQ(total(simulator.removed()), before);
        simulator.setControls(cutting());
        ASSERT_TRUE(soon([&] { return total(simulator.removed()) > before + 0.01; })) << round;
    }
}

TEST(Simulator, StopsCleanlyInAnyState) {
    const auto piece = test::blockOnTheBench(test::kCaries);
    for (int i = 0; i < 25; ++i) {
        SpyDevice device(stroking());
        {
            Simulator simulator(piece, test::flatBur(), HapticSettings(), device, {});
            simulator.setControls(cutting());
            if (i % 3 == 1) simulator.request(Edit::Reset);
            std::this_thread::sleep_for(i % 5 * 12ms);
        }
        ASSERT_EQ(device.force(), 0);
    }
}

TEST(Simulator, WithoutADeviceItJustWatches) {
    NullDevice device(at(0, 0, 5));
    Simulator simulator(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {});
    std::vector<Tick> ticks;
    EXPECT_TRUE(soon([&] {
        simulator.fetchTicks(ticks);
        return ticks.size() > 20;
    }));
    EXPECT_EQ(ticks.back().contacts, 0);
    EXPECT_EQ(ticks.back().hand.position, Vec3(0, 0, 5));
}

}  // namespace
}  // namespace tactooth
