// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/live/live_runner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

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

/// Comes down on the block, strokes over it, half a millimetre deep, and lifts off, over and over and each time a
/// little deeper: after a stall of the machine the force waits until the bur was free, and there is always something to
/// cut.
std::vector<DeviceKeyframe> stroking() {
    std::vector<DeviceKeyframe> script;
    for (int i = 0; i < 30; ++i) {
        const double start = 1.5 * i, depth = 0.5 + 0.04 * i;
        script.push_back(moment(start, at(-0.5, 0, 0.3), 1));
        for (int stroke = 0; stroke < 4; ++stroke) {
            script.push_back(moment(start + 0.3 * (1 + stroke), at(stroke % 2 ? 0.5 : -0.5, 0, -depth), 1));
        }
    }
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

SessionControls cutting() {
    SessionControls controls;
    controls.cutting = true;
    return controls;
}

/// Waits until a condition holds; the machine may be busy.
template <class Condition>
bool soon(const Condition& condition, std::chrono::seconds limit = 60s) {
    const auto end = Clock::now() + limit;
    while (!condition()) {
        if (Clock::now() > end) return false;
        std::this_thread::sleep_for(2ms);
    }
    return true;
}

/// Waits until what was asked for and what was under way is cut: until nothing has changed for a tenth of a second in
/// ticks.
bool waitUntilCarved(const LiveRunner& runner) {
    constexpr std::uint64_t kQuiet = 100;
    std::uint64_t since = runner.feed().timing().ticks, updates = runner.feed().surfaceUpdates();
    return soon([&] {
        const std::uint64_t ticks = runner.feed().timing().ticks, newest = runner.feed().surfaceUpdates();
        if (std::exchange(updates, newest) != newest) since = ticks;
        return ticks > since + kQuiet;
    });
}

TEST(LiveRunner, CutsABlockLive) {
    const auto piece = test::blockOnTheBench();
    SpyDevice device(stroking());
    std::atomic<std::uint64_t> heard{0};
    std::vector<Tick> ticks;
    double removedOnline = 0;
    {
        LiveRunner runner(piece, test::flatBur(), HapticSettings(), device, [&](const Tick&) { ++heard; });
        runner.setControls(cutting());
        const auto end = Clock::now() + 2s;
        EXPECT_TRUE(soon([&] {
            runner.feed().fetchTicks(ticks);
            return Clock::now() > end && ticks.size() > 100 && ticks.back().spindle.speedRpm > 10000 &&
                   runner.feed().surfaceUpdates() > 3 && total(runner.feed().removed()) > 0.01 &&
                   device.strongest() > 0.05;
        }));
        EXPECT_GT(runner.feed().surface()->revision, 3U);
        EXPECT_GT(runner.feed().timing().ticks, 100U);
        removedOnline = total(runner.feed().removed());
    }
    // A voxel's share falls a little where the last sweep turned the wall's normal: never by as much as the voxel.
    EXPECT_GE(total(piece->removed()), removedOnline - std::pow(test::kVoxel, 3));
    EXPECT_GT(heard, 100U);
    EXPECT_FALSE(device.wasForceTooLarge());
    EXPECT_GT(device.strongest(), 0.05);
    EXPECT_EQ(device.force(), 0);  // the last force sent to a device is zero
    ASSERT_GT(ticks.size(), 100U);
    for (std::size_t i = 1; i < ticks.size(); ++i) ASSERT_GE(ticks[i].time, ticks[i - 1].time);
    EXPECT_GT(ticks.back().spindle.speedRpm, 10000);
}

TEST(LiveRunner, InTouchModeNothingIsCut) {
    const auto piece = test::blockOnTheBench();
    SpyDevice device(stroking());
    {
        LiveRunner runner(piece, test::flatBur(), HapticSettings(), device, {});
        EXPECT_TRUE(soon([&] { return device.strongest() > 0.05; }));
    }
    EXPECT_EQ(total(piece->removed()), 0);
}

TEST(LiveRunner, ItsFirstTickHasTheControlsItBeganWith) {
    for (int i = 0; i < 50; ++i) {
        SpyDevice device(stroking());
        std::vector<Tick> ticks;
        LiveRunner runner(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {}, 4000, {}, nullptr,
                          cutting());
        ASSERT_TRUE(soon([&] {
            runner.feed().fetchTicks(ticks);
            return !ticks.empty();
        }));
        EXPECT_TRUE(ticks.front().input.cutting);
    }
}

TEST(LiveRunner, ForceSwitchedOffLeavesTheDeviceLimp) {
    SpyDevice device(dipping());
    LiveRunner runner(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {});
    EXPECT_TRUE(soon([&] { return device.force() > 0.01; }));
    SessionControls off;
    off.forceEnabled = false;
    runner.setControls(off);
    EXPECT_TRUE(soon([&] { return device.force() == 0; }));
    const auto ticks = runner.feed().timing().ticks.load();
    EXPECT_TRUE(soon([&] { return runner.feed().timing().ticks > ticks + 20; }));
    EXPECT_EQ(device.force(), 0);
}

TEST(LiveRunner, StartingInsideTheToothGivesNoForce) {
    SpyDevice device(resting(-0.5));
    LiveRunner runner(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {});
    EXPECT_TRUE(soon([&] { return runner.feed().forceState() == ForceState::AwaitsFreeSpace; }))
        << "a place was found for it";
    const auto ticks = runner.feed().timing().ticks.load();
    EXPECT_TRUE(soon([&] { return runner.feed().timing().ticks > ticks + 300; }));
    EXPECT_EQ(device.strongest(), 0);
    EXPECT_TRUE(soon([&] { return runner.feed().forceState() == ForceState::AwaitsFreeSpace; }));
}

TEST(LiveRunner, EndingMidPressFadesTheForceOutFirst) {
    for (int i = 0; i < 5; ++i) {
        SpyDevice device(dipping());
        {
            LiveRunner runner(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {});
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

/// As the window does for another bur, tooth or drive: one runner ends, and the next begins with the same device.
TEST(LiveRunner, AnotherBurToothOrDriveMidPressChangesTheForceGently) {
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
        LiveRunner runner(piece, bur, settings, device, {});
        runner.setControls(cutting());
        EXPECT_TRUE(soon([&] { return device.force() > 0.05; }));
    }
    EXPECT_EQ(device.force(), 0);
    EXPECT_FALSE(device.hasJumped());
}

TEST(LiveRunner, TwoDevicesMoveTurbineAndMirror) {
    SpyDevice first(dipping());
    SpyDevice second({moment(0, at(10, 20, 30), 0), moment(0.2, at(10, 20, 30), 0), moment(0.3, at(12, 20, 30), 0)});
    LiveRunner runner(test::blockOnTheBench(), test::flatBur(), HapticSettings(), first, {}, 1000, {}, &second);
    EXPECT_TRUE(soon([&] { return std::abs(runner.feed().mirrorMotion().position.x() - 2) < 1e-9; }));
    EXPECT_TRUE(soon([&] { return first.force() > 0.01; }));
    EXPECT_EQ(second.strongest(), 0);
}

TEST(LiveRunner, WhatWasCutIsKeptWhenTheDeviceIsLost) {
    SpyDevice device(stroking());
    LiveRunner runner(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {});
    runner.setControls(cutting());
    ASSERT_TRUE(soon([&] { return total(runner.feed().removed()) > 0.01; }));
    device.plugIn(false);
    ASSERT_TRUE(soon([&] { return device.force() == 0; }));
    ASSERT_TRUE(waitUntilCarved(runner));
    const double kept = total(runner.feed().removed());
    EXPECT_GT(kept, 0.01);
    device.plugIn(true);
    EXPECT_TRUE(soon([&] { return total(runner.feed().removed()) > 1.2 * kept; })) << "and the session goes on";
}

TEST(LiveRunner, ARegisteredDeviceStartsWhereTheToolIsAndMovesItScaled) {
    SpyDevice device(
        {moment(0, at(100, 50, -30), 0), moment(1, at(100, 50, -30), 0), moment(1.1, at(103, 50, -30), 0)});
    std::vector<Tick> ticks;
    const DeviceRegistration registration{at(1, 2, 5), Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()))};
    LiveRunner runner(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {}, 1000, registration);
    SessionControls controls;
    controls.motionScaling = 3;
    runner.setControls(controls);
    EXPECT_TRUE(soon([&] {
        runner.feed().fetchTicks(ticks);
        return !ticks.empty() && (ticks.back().input.device.position - Vec3(1, 3, 5)).norm() < 1e-9;
    }));
    EXPECT_LT((ticks.front().input.device.position - Vec3(1, 2, 5)).norm(), 1e-9);
}

TEST(LiveRunner, AHandWithAPlaceOfItsOwnIsFineFromTheFirstTickOn) {
    SpyDevice device({moment(0, at(103, 50, -30), 0)});
    std::vector<Tick> ticks;
    const DeviceRegistration registration{at(1, 2, 5), Quat::Identity(), Vec3(100, 50, -30)};
    SessionControls fine;
    fine.motionScaling = 3;
    LiveRunner runner(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {}, 1000, registration,
                      nullptr, fine);
    EXPECT_TRUE(soon([&] {
        runner.feed().fetchTicks(ticks);
        return ticks.size() > 10;
    }));
    for (const Tick& tick : ticks) EXPECT_LT((tick.input.device.position - Vec3(2, 2, 5)).norm(), 1e-9);
}

TEST(LiveRunner, AButtonOfTheDeviceTurnsTouchIntoCut) {
    std::vector<DeviceKeyframe> script = {moment(0, at(0, 0, 3), 1), moment(0.3, at(0, 0, 3), 1),
                                          moment(1.3, at(0, 0, 3), 1)};
    script[1].sample.buttons = 2;
    SpyDevice device(script);
    std::atomic<bool> cutting{false};
    LiveRunner runner(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device,
                      [&](const Tick& tick) { cutting = tick.input.cutting; });
    EXPECT_TRUE(soon([&] { return cutting.load(); }));
}

TEST(LiveRunner, AButtonHandsOverToTheMirrorWhileTheToolStays) {
    std::vector<DeviceKeyframe> script = {moment(0, at(0, 0, 3), 1), moment(0.3, at(0, 0, 3), 1),
                                          moment(1.3, at(0, 0, 3), 1), moment(1.5, at(4, 0, 3), 1)};
    script[1].sample.buttons = 1;
    SpyDevice device(script);
    std::vector<Tick> ticks;
    LiveRunner runner(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {});
    EXPECT_TRUE(soon([&] { return std::abs(runner.feed().mirrorMotion().position.x() - 4) < 1e-9; }));
    runner.feed().fetchTicks(ticks);
    EXPECT_EQ(ticks.back().input.device.position, Vec3(0, 0, 3));
}

TEST(LiveRunner, ALostDeviceGetsNoForceAndComesBackWithARamp) {
    SpyDevice device(dipping());
    LiveRunner runner(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {});
    EXPECT_TRUE(soon([&] { return device.force() > 0.01; }));
    device.plugIn(false);
    EXPECT_TRUE(soon([&] { return device.force() == 0; }));
    const auto ticks = runner.feed().timing().ticks.load();
    EXPECT_TRUE(soon([&] { return runner.feed().timing().ticks > ticks + 20; }));
    EXPECT_EQ(device.force(), 0);
    device.plugIn(true);
    EXPECT_TRUE(soon([&] { return device.force() > 0.01; }));
    EXPECT_FALSE(device.wasForceTooLarge());
}

TEST(LiveRunner, ADeviceThatIsLostFromTheStartIsNoHand) {
    SpyDevice device(resting(-0.5));
    device.plugIn(false);
    std::atomic<bool> placed{false};
    LiveRunner runner(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device,
                      [&](const Tick& tick) { placed = placed || tick.contact.placed; });
    EXPECT_TRUE(soon([&] { return runner.feed().timing().ticks > 30; }));
    EXPECT_FALSE(placed);
    EXPECT_EQ(device.strongest(), 0);
}

TEST(LiveRunner, TheForceOverridesOfTheSettingsHoldUntilTheControlsSayOtherwise) {
    HapticSettings soft;
    soft.force.stiffness = 0.0;
    soft.force.damping = 0.0;
    SpyDevice device(dipping());
    LiveRunner runner(test::blockOnTheBench(), test::flatBur(), soft, device, {});
    EXPECT_TRUE(soon([&] { return runner.feed().timing().ticks > 100; }));
    EXPECT_EQ(device.strongest(), 0);
    runner.setControls({});
    EXPECT_TRUE(soon([&] { return device.strongest() > 0.01; }));
}

TEST(LiveRunner, TheLargerOfBothPedalsCounts) {
    SpyDevice device({moment(0, at(0, 0, 1), 0.25)});
    std::atomic<double> pedal{-1};
    LiveRunner runner(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device,
                      [&](const Tick& tick) { pedal = tick.input.pedal; });
    EXPECT_TRUE(soon([&] { return pedal == 0.25; }));
    SessionControls controls;
    controls.pedal = 0.75;
    runner.setControls(controls);
    EXPECT_TRUE(soon([&] { return pedal == 0.75; }));
}

TEST(LiveRunner, AResetPutsTheToothBackWhileItRuns) {
    const auto piece = test::blockOnTheBench(test::kCaries);
    SpyDevice device(stroking());
    LiveRunner runner(piece, test::flatBur(), HapticSettings(), device, {});
    runner.setControls(cutting());
    ASSERT_TRUE(soon([&] { return total(runner.feed().removed()) > 0.01; }));
    runner.setControls({});
    ASSERT_TRUE(waitUntilCarved(runner));
    runner.request(Edit::Reset);
    EXPECT_TRUE(soon([&] { return total(runner.feed().removed()) == 0; }));
    EXPECT_TRUE(soon([&] { return runner.feed().surface()->patches.empty(); }));
}

TEST(LiveRunner, WhatIsLooseFallsWhileTheBurIsInTheAir) {
    const auto piece = test::blockOnTheBench();
    test::cutARidgeOff(*piece);
    const double ground = total(piece->removed());
    SpyDevice device({moment(0, at(0, 0, -0.99), 0), moment(0.5, at(0, 0, -1.05), 0), moment(1, at(0, 0, 1), 0)});
    LiveRunner runner(piece, test::flatBur(), HapticSettings(), device, {});
    EXPECT_TRUE(soon([&] { return runner.feed().loss().pieces == 1; }));
    EXPECT_TRUE(soon([&] { return total(runner.feed().removed()) > ground + 1; }));
    EXPECT_TRUE(soon([&] { return !contains(*runner.feed().surface(), Vec3(0, 1, -0.2)); }));
}

TEST(LiveRunner, UndoTakesBackTheCutsSinceTheBurWasLiftedWhileItRuns) {
    const auto piece = test::blockOnTheBench(test::kCaries);
    // Two cuts, with the bur in the air for 0.8 s between them, and then a rest in the air.
    SpyDevice device({moment(0, at(-0.5, 0, 0.3), 1), moment(0.3, at(-0.5, 0, -0.3), 1),
                      moment(0.6, at(-0.5, 0, 0.3), 1), moment(1.4, at(0.5, 0, 0.3), 1),
                      moment(1.7, at(0.5, 0, -0.4), 1), moment(2.0, at(0.5, 0, 0.5), 1)});
    LiveRunner runner(piece, test::flatBur(), HapticSettings(), device, {});
    runner.setControls(cutting());
    std::vector<Tick> ticks;
    ASSERT_TRUE(soon([&] {
        runner.feed().fetchTicks(ticks);
        return !ticks.empty() && ticks.back().time > 2.2;
    }));
    ASSERT_TRUE(waitUntilCarved(runner));
    ASSERT_FALSE(runner.feed().surface()->patches.empty());
    const double both = total(runner.feed().removed());
    runner.request(Edit::Undo);
    ASSERT_TRUE(soon([&] { return total(runner.feed().removed()) < both; }));
    const double one = total(runner.feed().removed());
    EXPECT_GT(one, 0.1 * both);
    runner.request(Edit::Undo);
    EXPECT_TRUE(soon([&] { return total(runner.feed().removed()) == 0; }));
    runner.request(Edit::Undo);
    ASSERT_TRUE(waitUntilCarved(runner));
    EXPECT_EQ(total(runner.feed().removed()), 0);
    EXPECT_EQ(visibleMesh(*runner.feed().surface()).mesh.triangles.size(), 12U) << "the block as it came";
}

TEST(LiveRunner, TheToothCanBeSavedWhileItIsCut) {
    const auto piece = test::blockOnTheBench(test::kCaries);
    SpyDevice device(stroking());
    LiveRunner runner(piece, test::flatBur(), HapticSettings(), device, {});
    runner.setControls(cutting());
    ASSERT_TRUE(soon([&] { return total(runner.feed().removed()) > 0.01; }));
    const auto saved = parseSavedTooth(savedToothBytes(runner.snapshot().get(), {}), "saved");
    ASSERT_TRUE(saved) << saved.error().message();
    EXPECT_GT(saved->removed[static_cast<std::size_t>(test::kCaries)], 0.01);
    EXPECT_FALSE(saved->cuts.empty());
}

TEST(LiveRunner, ASnapshotIsTheToothBeforeWhatIsRequestedAfterIt) {
    const auto piece = test::cutBlock();
    const std::vector<std::byte> before = toothFileBytes(*piece, {});
    SpyDevice device(stroking());
    std::future<ToothSnapshot> first, last;
    {
        LiveRunner runner(piece, test::flatBur(), HapticSettings(), device, {});
        first = runner.snapshot();
        runner.request(Edit::Reset);
        ASSERT_TRUE(soon([&] { return total(runner.feed().removed()) == 0; }));
        last = runner.snapshot();  // the runner ends
    }
    EXPECT_EQ(savedToothBytes(first.get(), {}), before);
    EXPECT_EQ(total(last.get().removed), 0);
}

TEST(LiveRunner, ACutModelGoesOnFromOneRunnerToTheNext) {
    const auto piece = test::blockOnTheBench(test::kCaries);
    for (int round = 0; round < 3; ++round) {
        const double before = total(piece->removed());
        SpyDevice device(stroking());
        LiveRunner runner(piece, test::flatBur(), HapticSettings(), device, {});
        EXPECT_EQ(total(runner.feed().removed()), before);
        runner.setControls(cutting());
        ASSERT_TRUE(soon([&] { return total(runner.feed().removed()) > before + 0.01; })) << round;
    }
}

TEST(LiveRunner, StopsCleanlyInAnyState) {
    const auto piece = test::blockOnTheBench(test::kCaries);
    for (int i = 0; i < 25; ++i) {
        SpyDevice device(stroking());
        {
            LiveRunner runner(piece, test::flatBur(), HapticSettings(), device, {});
            runner.setControls(cutting());
            if (i % 3 == 1) runner.request(Edit::Reset);
            std::this_thread::sleep_for(i % 5 * 12ms);
        }
        ASSERT_EQ(device.force(), 0);
    }
}

TEST(LiveRunner, WithoutADeviceItJustWatches) {
    NullDevice device(at(0, 0, 5));
    LiveRunner runner(test::blockOnTheBench(), test::flatBur(), HapticSettings(), device, {});
    std::vector<Tick> ticks;
    EXPECT_TRUE(soon([&] {
        runner.feed().fetchTicks(ticks);
        return ticks.size() > 20;
    }));
    EXPECT_EQ(ticks.back().contact.triangles, 0);
    EXPECT_EQ(ticks.back().input.device.position, Vec3(0, 0, 5));
}

}  // namespace
}  // namespace tactooth
