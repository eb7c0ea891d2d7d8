// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <semaphore.h>

#include <array>
#include <atomic>
#include <mutex>
#include <thread>

#include "devices/base/haptic_device.h"
#include "devices/openhaptics/hd_library.h"
#include "geometry/util/message.h"
#include "geometry/util/triple_buffer.h"

namespace tactooth {

/// Reading of a pen by the driver's callback.
struct HdReading {
    std::array<double, 16> transform{};  // in the layout of HDAPI
    std::uint32_t buttons = 0;
    double motorTemperature = 0;
    bool calibrated = false;
    double time = 0;  // s of the monotonic clock
};

/// A pen's data shared by the driver's callback and the servo thread.
struct HdPen {
    HdPen() { sem_init(&ready, 0, 0); }
    ~HdPen() { sem_destroy(&ready); }
    HdPen(const HdPen&) = delete;
    HdPen& operator=(const HdPen&) = delete;

    TripleBuffer<HdReading> reading;         // callback -> servo
    TripleBuffer<Vec3> force{Vec3::Zero()};  // servo -> callback; N, in HDAPI's frame
    sem_t ready;                             // posted by the callback after each reading
    std::atomic<const Message*> faultMessage{nullptr};
    std::atomic<bool> lost{false};
    std::atomic<bool> forceActive{false};  // its last force was not zero

    // Used by the callback, or by the maintenance thread while no callback is scheduled.
    SampleListener listener;
    std::string name;
    HdHandle handle = 0;
    bool active = false;
    std::int32_t calibrationStyle = 0;
    unsigned forceAge = 0;  // ticks since the last force of the servo thread
    unsigned ticks = 0;
    unsigned faultTicks = 0;      // ticks for which a transient fault is still shown
    unsigned zeroForcesLeft = 0;  // number of zero forces still to be sent to a lost pen
    double motorTemperature = 0;
    bool calibrated = false;
};

/// The vendor's scheduler with all pens of this process: one callback serves all of them.
class HdDriver {
public:
    static constexpr std::size_t kMaxPens = 4;

    /// The driver of this process; created on demand.
    [[nodiscard]] static Expected<std::shared_ptr<HdDriver>> shared(const std::string& library, double rateHz);
    HdDriver(std::shared_ptr<const HdLibrary> library, double rateHz);
    ~HdDriver();
    HdDriver(const HdDriver&) = delete;
    HdDriver& operator=(const HdDriver&) = delete;

    /// Starts the pen `name` (empty: the default one) and fills in its capabilities. The callback calls `listener`.
    [[nodiscard]] Expected<HdPen*> start(const std::string& name, DeviceInfo& info, const SampleListener& listener);
    void stop(HdPen& pen);

private:
    static std::uint32_t onTick(void* driver);
    void countTick();
    void exchange(HdPen& pen);
    void monitorMotors(HdPen& pen);
    void monitorCalibration(HdPen& pen, bool mayUpdate);
    void sendZeroForce(HdPen& pen);
    void takeErrors(HdPen& pen);
    [[nodiscard]] Expected<HdHandle> startDevice(const std::string& name);
    [[nodiscard]] bool isAnyForceActive() const;
    void describe(HdPen& pen, DeviceInfo& info);
    void pause();
    void resume();
    void maintain(const std::stop_token& stop);

    std::shared_ptr<const HdLibrary> library_;
    const HdFunctions& call_;
    std::mutex mutex_;  // protects all members except those of the callback
    std::array<HdPen, kMaxPens> pens_;
    bool running_ = false;
    unsigned long task_ = 0;
    double rateHz_;
    // Used only by the callback.
    double countedFrom_ = 0;    // s of the monotonic clock
    unsigned counted_ = 0;      // ticks since then
    bool rateFault_ = false;    // ticks come far too often, so the age of a force cannot be counted in ticks
    std::jthread maintenance_;  // last member: it uses all of the above
};

}  // namespace tactooth
