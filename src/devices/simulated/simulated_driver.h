// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <semaphore.h>

#include <atomic>
#include <string_view>
#include <thread>

#include "devices/base/haptic_device.h"
#include "geometry/util/triple_buffer.h"
#include "haptics/latency_histogram.h"

namespace tactooth {

/// A device without hardware that sets the servo rate as a vendor's driver does: its own thread delivers a sample a
/// tick. It rests in one place. `tactooth realtime` measures with it what a device's link costs.
class SimulatedDriver final : public HapticDevice {
public:
    static constexpr std::string_view kName = "simulated";  ///< for tactooth-hand alone, not for --device

    explicit SimulatedDriver(double rateHz = 1000);
    ~SimulatedDriver() override;

    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override;
    void close() override;
    [[nodiscard]] bool drivesServoRate() const override { return true; }
    void waitForTick(double longest) override;
    [[nodiscard]] DeviceSample read(double elapsed) override;
    void write(const SafeWrench& wrench) override;

    /// Time from a sample to the force that answers it, us.
    [[nodiscard]] const LatencyHistogram& responseTime() const { return responseTime_; }

private:
    void run(const std::stop_token& stop);

    double rateHz_;
    DeviceInfo info_;
    sem_t ready_;                         // posted after each sample
    TripleBuffer<double> measuredAt_{0};  // s of the monotonic clock
    bool answered_ = true;                // a force has followed the newest sample
    LatencyHistogram responseTime_;
    std::jthread thread_;  // last member: it uses all others
};

}  // namespace tactooth
