// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "devices/simulated/scripted_device.h"
#include "session/bench_scene.h"
#include "session/model/session_model.h"

namespace tactooth::test {

/// Runs the work at once, in the caller's thread.
inline std::jthread runInline(const std::function<void()>& work) {
    work();
    return {};
}

/// Keeps the work until the test runs it.
class ManualExecutor {
public:
    [[nodiscard]] TaskExecutor executor() {
        return [this](std::function<void()> work) {
            waiting_.push_back(std::move(work));
            return std::jthread();
        };
    }
    /// The oldest work that waits.
    void runNext() {
        const std::function<void()> work = std::move(waiting_.front());
        waiting_.erase(waiting_.begin());
        work();
    }
    [[nodiscard]] std::size_t waiting() const { return waiting_.size(); }

private:
    std::vector<std::function<void()>> waiting_;
};

/// Remembers the loudest water and suction that the servo has published.
class SpySound final : public SoundOutput {
public:
    void publish(const DrillSoundState& state) override {
        water_ = state.water;
        suction_ = state.suction;
        ++published_;
    }
    void setMixer(const SoundMixer&) override {}
    void setPlacement(const SoundPlacement&) override {}
    void setHeadphones(bool) override {}
    void setRoom(bool) override {}
    void setKit(std::shared_ptr<const SoundKit>) override {}
    [[nodiscard]] SoundStatus status() const override { return SoundStatus::Silent; }

    [[nodiscard]] double water() const { return water_; }
    [[nodiscard]] double suction() const { return suction_; }
    [[nodiscard]] int published() const { return published_; }

private:
    std::atomic<double> water_{-1}, suction_{-1};  // of the newest state
    std::atomic<int> published_{0};
};

/// A device whose hand stands still; the test sets its buttons and its fault.
class StillDevice final : public HapticDevice {
public:
    StillDevice(const Vec3& workspace, const std::optional<Vec3>& workspaceCentre, const Vec3& hand) : hand_(hand) {
        info_.workspace = workspace;
        info_.workspaceCentre = workspaceCentre;
    }
    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override { return {}; }
    void close() override {}
    [[nodiscard]] DeviceSample read(double) override {
        return {.hand = {hand_, Quat::Identity()}, .buttons = buttons_};
    }
    void write(const SafeWrench&) override {}
    void suspendInput(bool suspended) override { suspended_ = suspended; }
    [[nodiscard]] const Message* faultMessage() const override { return fault_; }

    void setButtons(std::uint32_t buttons) { buttons_ = buttons; }
    void setFault(const Message* fault) { fault_ = fault; }
    [[nodiscard]] bool isSuspended() const { return suspended_; }

private:
    DeviceInfo info_;
    Vec3 hand_;
    std::atomic<std::uint32_t> buttons_{0};
    std::atomic<const Message*> fault_{nullptr};
    std::atomic<bool> suspended_{false};
};

[[nodiscard]] inline std::unique_ptr<StillDevice> unboundedDevice() {
    return std::make_unique<StillDevice>(Vec3::Zero(), std::nullopt, Vec3::Zero());
}

/// The block of bench_scene.h, whose top lies at zero.
[[nodiscard]] inline SessionTooth blockTooth(double mesialX = 1) {
    SessionTooth tooth;
    tooth.name = "Block";
    tooth.piece = blockOnTheBench();
    tooth.mesialX = mesialX;
    return tooth;
}

[[nodiscard]] inline SessionBur flatSessionBur() {
    const auto mesh = std::make_shared<const TriangleMesh>(flatBurMesh());
    return withHead({.name = "Flat", .instrument = flatBur(), .shown = mesh, .blurred = mesh, .file = {}});
}

/// Steps the model until the condition holds; false if it does not within a minute.
[[nodiscard]] inline bool stepUntil(SessionModel& model, const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (std::chrono::steady_clock::now() < end) {
        (void)model.step(0.01);
        if (condition()) return true;
        std::this_thread::yield();
    }
    return false;
}

/// A scripted hand cuts the block. Returns when it has left the block and a long time (in ticks) has passed since
/// anything was removed.
inline void cutBlock(SessionModel& model) {
    const auto at = [](double time, double z) {
        return DeviceKeyframe{time, {.hand = {Vec3(0, 0, z), Quat::Identity()}, .pedal = 1}};
    };
    std::vector<DeviceKeyframe> script{at(0, 1), at(0.2, 1), at(0.4, -0.4), at(0.8, -0.4), at(1, 1)};
    model.setCutting(true);
    model.install(DeviceSlot::First, std::make_unique<ScriptedDevice>(std::move(script), "press", true));
    ASSERT_TRUE(
        stepUntil(model, [&] { return model.runner() != nullptr && total(model.runner()->feed().removed()) > 0.01; }));
    constexpr std::uint32_t kQuiet = 300;
    MaterialVolumes removed;
    std::uint32_t since = 0;
    ASSERT_TRUE(stepUntil(model, [&] {
        const Tick& tick = model.log().newest();
        const MaterialVolumes now = model.runner()->feed().removed();
        if (now != removed || tick.contact.triangles > 0 || tick.input.device.position.z() < 0.9)
            removed = now, since = tick.number;
        return tick.number > since + kQuiet;
    }));
}

}  // namespace tactooth::test
