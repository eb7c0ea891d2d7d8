// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <thread>

#include "devices/base/haptic_device.h"
#include "haptics/force_pipeline.h"
#include "haptics/servo_loop.h"

namespace tactooth::test {

/// Whether a condition becomes true within a time limit that only a broken program exceeds.
template <class Condition>
bool soon(const Condition& condition, std::chrono::seconds limit = std::chrono::seconds(60)) {
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

/// Whether a device soon reports this text. A busy machine may stall the device for a moment, and the device reports
/// that first.
inline bool soonSays(const HapticDevice& device, const std::string& text) {
    return soon([&] {
        const Message* const faultMessage = device.faultMessage();
        return faultMessage != nullptr && faultMessage->in(Language::English).find(text) != std::string::npos;
    });
}

/// Whether a device soon reports nothing. A stall of a busy machine is reported for 3 s, whatever the test does.
inline bool soonSaysNothing(const HapticDevice& device) {
    return soon([&] { return device.faultMessage() == nullptr; });
}

inline constexpr double kWall = -2;            // mm, height of a plane in the device's frame
inline constexpr double kWallStiffness = 0.4;  // N/mm

/// A servo loop that renders a plane to a device.
class PlaneServo {
public:
    explicit PlaneServo(HapticDevice& device)
        : device_(device),
          pipeline_(device.info().limits, device.info().poseLimits),
          loop_(
              1000, [this](double elapsed) { tick(elapsed); },
              device.drivesServoRate()
                  ? std::function<void(double)>([&device](double longest) { device.waitForTick(longest); })
                  : std::function<void(double)>()) {}

    [[nodiscard]] ForceState state() const { return state_; }
    [[nodiscard]] std::uint32_t buttons() const { return buttons_; }
    [[nodiscard]] std::uint64_t faults() const { return faults_; }
    [[nodiscard]] long ticks() const { return static_cast<long>(loop_.timing().ticks.load()); }
    /// s: age of the oldest reading for which a force was still rendered.
    [[nodiscard]] double oldestWithForce() const { return oldestWithForce_; }
    /// Largest force since the start, N.
    [[nodiscard]] double strongest() const { return strongest_; }
    void hang(std::chrono::milliseconds time) { pause_ = static_cast<int>(time.count()); }

private:
    void tick(double elapsed) {
        if (const int pause = pause_.exchange(0); pause > 0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(pause));
        }
        const DeviceSample sample = device_.read(elapsed);
        ForceCommand wanted;
        wanted.connected = sample.connected;
        wanted.hand = sample.hand.position;
        wanted.turn = sample.hand.rotation;
        wanted.age = sample.age;
        wanted.isFresh = sample.isFresh;
        wanted.motorTemperature = sample.motorTemperature;
        wanted.deflection = std::max(0.0, kWall - sample.hand.position.z());
        wanted.stiffness = wanted.deflection > 0 ? kWallStiffness : 0;
        wanted.touching = wanted.deflection > 0;
        wanted.wrench.force = Vec3(0, 0, kWallStiffness * wanted.deflection);
        const SafeWrench sent = pipeline_.pass(wanted, elapsed);
        device_.write(sent);
        device_.recordPoseFault(pipeline_.fault(), elapsed);
        strongest_ = std::max(strongest_.load(), sent.force().norm());
        if (!sent.force().isZero(0)) oldestWithForce_ = std::max(oldestWithForce_.load(), sample.age);
        state_ = pipeline_.state();
        faults_ = pipeline_.faults();
        buttons_ = sample.buttons;
    }

    HapticDevice& device_;
    ForcePipeline pipeline_;
    std::atomic<ForceState> state_{ForceState::Off};
    std::atomic<std::uint32_t> buttons_{0};
    std::atomic<std::uint64_t> faults_{0};
    std::atomic<double> oldestWithForce_{0};
    std::atomic<double> strongest_{0};
    std::atomic<int> pause_{0};
    ServoLoop loop_;
};

}  // namespace tactooth::test
