// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "devices/base/haptic_device.h"
#include "devices/process/hand_supervisor.h"
#include "haptics/latency_histogram.h"

namespace tactooth {

/// Any device, whose link runs in a process of its own, tactooth-hand. This object is the program's end of the shared
/// memory: all of the device's properties, samples, forces and faults pass through it. A process that ends, is stopped
/// or falls silent counts as a lost device within a few ms, and is started again.
class HandProcessDevice final : public HapticDevice {
public:
    explicit HandProcessDevice(const HandRequest& request);
    ~HandProcessDevice() override { close(); }

    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override;
    void close() override;
    [[nodiscard]] DeviceSample read(double elapsed) override;
    [[nodiscard]] bool drivesServoRate() const override { return description_.drivesServoRate != 0; }
    void waitForTick(double longest) override;
    void suspendInput(bool rests) override;
    [[nodiscard]] const Message* faultMessage() const override;
    void write(const SafeWrench& wrench) override;

    /// Any thread: the number of the process; 0 while none runs.
    [[nodiscard]] pid_t processId() const { return supervisor_.processId(); }
    /// What the second process adds to the time from a sample to its force, of a device that drives the servo rate, us:
    /// the way of a sample from there to here, and of its force back.
    [[nodiscard]] const LatencyHistogram& addedLatency() const { return addedLatency_; }
    /// Time in that process from a sample to the force that answers it, us.
    [[nodiscard]] const LatencyHistogram& responseTime() const { return responseTime_; }

private:
    static constexpr std::size_t kRemembered = 16;

    void attach(HandLink* link);
    void shareProcessor();
    [[nodiscard]] bool isAttached();
    void take(const PoseMessage& message, double now);
    void noteFault(HandFault fault, double elapsed);
    [[nodiscard]] const Message* deviceMessage() const;

    HandSupervisor supervisor_;
    double longestSilence_;  // s without a pose: then the device counts as lost
    DeviceInfo info_;
    DeviceDescription description_;
    std::atomic<bool> suspended_{false};

    // Of the servo thread.
    HandLink* link_ = nullptr;
    std::thread::id servoThread_;
    bool isSameDevice_ = false;  // the device behind the link is the one that was opened
    std::optional<SlotReader<PoseMessage>> poses_;
    std::optional<SlotWriter<ForceMessage>> forces_;
    PoseMessage pose_;  // the newest
    bool hasPose_ = false;
    std::uint32_t freshness_ = 0;  // of the last sample that was handed on
    std::uint32_t sequence_ = 0;   // of the last force
    std::uint32_t rings_ = 0;
    double silence_ = 0;                            // s for which no pose has come
    double readDelay_ = 0;                          // s from the publication of the newest pose to its reading
    std::array<double, kRemembered> readDelays_{};  // s, of the poses behind the newest forces, by their sequence
    double refusalLeft_ = 0;                        // s for which a refused force is still shown
    LatencyHistogram addedLatency_;
    LatencyHistogram responseTime_;

    std::atomic<HandFault> refusal_{HandFault::None};
    std::atomic<bool> isSilent_{false};
    std::atomic<bool> isOther_{false};

    mutable std::mutex textMutex_;  // protects the two below
    mutable HandLink* textLink_ = nullptr;
    mutable std::optional<SlotReader<HandText>> texts_;
};

}  // namespace tactooth
