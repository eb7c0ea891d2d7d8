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

/// What the driver's callback has read of a pen.
struct HdReading {
    std::array<double, 16> transform{};  // as HDAPI gives it
    std::uint32_t buttons = 0;
    double motorTemperature = 0;
    bool calibrated = false;
    double time = 0;  // s of the monotonic clock
};

/// A pen between the driver's callback and the servo thread.
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
    std::atomic<bool> forceActive{false};  // its last force was one

    // The callback's, or the maintenance's while no callback is scheduled.
    std::string name;
    HdHandle handle = 0;
    bool active = false;
    std::int32_t calibrationStyle = 0;
    unsigned forceAge = 0;  // ticks since the servo's last force
    unsigned ticks = 0;
    unsigned faultTicks = 0;      // left for a trouble that passes
    unsigned zeroForcesLeft = 0;  // how often a lost pen is still told to make no force
    double motorTemperature = 0;
    bool calibrated = false;
};

/// The vendor's scheduler with all pens of this process: one callback serves them all.
class HdDriver {
public:
    static constexpr std::size_t kMaxPens = 4;

    /// The one of this process; made when there is none.
    [[nodiscard]] static Expected<std::shared_ptr<HdDriver>> shared(const std::string& library, double rateHz);
    HdDriver(std::shared_ptr<const HdLibrary> library, double rateHz);
    ~HdDriver();
    HdDriver(const HdDriver&) = delete;
    HdDriver& operator=(const HdDriver&) = delete;

    /// Starts the pen `name` (empty: the default one) and fills in what it can do.
    [[nodiscard]] Expected<HdPen*> start(const std::string& name, DeviceInfo& info);
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
    std::mutex mutex_;  // of everything but the callback
    std::array<HdPen, kMaxPens> pens_;
    bool running_ = false;
    unsigned long task_ = 0;
    double rateHz_;
    // The callback's.
    double countedFrom_ = 0;    // s of the monotonic clock
    unsigned counted_ = 0;      // ticks since then
    bool rateFault_ = false;    // they come far too often: how old a force is cannot be told by them
    std::jthread maintenance_;  // last: it uses all of the above
};

}  // namespace tactooth
