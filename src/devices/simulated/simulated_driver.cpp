// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/simulated/simulated_driver.h"

#include <pthread.h>

#include <chrono>
#include <string>

#include "devices/base/device_presets.h"
#include "devices/base/monotonic_clock.h"
#include "devices/base/timed_wait.h"
#include "geometry/util/assert.h"
#include "haptics/real_time.h"

namespace tactooth {

SimulatedDriver::SimulatedDriver(double rateHz) : rateHz_(rateHz) {
    TACTOOTH_ASSERT(rateHz > 0);
    sem_init(&ready_, 0, 0);
    const DevicePreset& preset = *findDevicePreset("touch");
    info_.name = std::string(preset.title) + " (simulated driver)";
    info_.rendersForce = info_.sensesRotation = true;
    info_.limits = limitsOf(preset);
    info_.stiffness = preset.stiffness;
    info_.workspace = preset.workspace;
}

SimulatedDriver::~SimulatedDriver() {
    close();
    sem_destroy(&ready_);
}

Expected<void> SimulatedDriver::open() {
    close();
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
    return {};
}

void SimulatedDriver::close() { thread_ = {}; }

void SimulatedDriver::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "driver");  // name for debuggers and profilers
    (void)acquireRealTimePriority();
    const auto period =
        std::chrono::duration_cast<MonotonicClock::duration>(std::chrono::duration<double>(1 / rateHz_));
    for (auto due = MonotonicClock::now() + period; !stop.stop_requested(); due += period) {
        std::this_thread::sleep_until(due);
        measuredAt_.write(monotonicSeconds());
        sem_post(&ready_);
        sampleListener()();
        due = std::max(due, MonotonicClock::now() - period);  // a late tick is skipped
    }
}

void SimulatedDriver::waitForTick(double longest) {
    waitForSemaphore(ready_, longest);
    while (sem_trywait(&ready_) == 0) {  // samples that arrived while the last one was processed
    }
}

DeviceSample SimulatedDriver::read(double /*elapsed*/) {
    DeviceSample sample;
    sample.isFresh = measuredAt_.refresh();
    answered_ = answered_ && !sample.isFresh;
    const double measuredAt = measuredAt_.value();
    sample.connected = measuredAt > 0;
    sample.age = sample.connected ? monotonicSeconds() - measuredAt : 0;
    return sample;
}

void SimulatedDriver::write(const SafeWrench& /*wrench*/) {
    if (answered_) return;
    answered_ = true;
    responseTime_.add(1e6 * (monotonicSeconds() - measuredAt_.value()));
}

}  // namespace tactooth
