// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "devices/base/pose_monitor.h"
#include "geometry/util/expected.h"
#include "geometry/util/pose.h"
#include "haptics/safety_limiter.h"

namespace tactooth {

/// Properties and limits of a device. All differences between devices are values here, so no code above this layer
/// needs to distinguish devices.
struct DeviceInfo {
    std::string name;  ///< display name
    bool rendersForce = false;
    bool sensesRotation = false;
    int buttonCount = 0;
    bool hasPedal = false;
    ForceLimits limits;                   ///< limits that the safety limiter enforces
    PoseLimits poseLimits;                ///< a reading beyond these limits is a pose fault
    Vec3 workspace = Vec3::Zero();        ///< size of the workspace, mm; zero: not bounded
    std::optional<Vec3> workspaceCentre;  ///< centre of the workspace in the device's frame, mm; none: unknown
    bool isInToothFrame = false;          ///< the tooth's frame: it reports the tool's pose, needs no registration
    double stiffness = std::numeric_limits<double>::infinity();  ///< N/mm: the stiffest wall that is stable at 1 kHz
};

/// The stiffest wall that such a device renders at another rate. At half the rate each tick adds twice the energy, so a
/// wall may be half as stiff (J. E. Colgate, G. Schenkel, "Passivity of a Class of Sampled-Data Systems", American
/// Control Conference 1994: b > k T / 2). Rates above 1 kHz do not raise the value, because the device's own mechanics
/// bound it.
[[nodiscard]] inline double maxStiffnessAt(double stiffness, double rateHz) {
    return stiffness * std::min(1.0, rateHz / 1000);
}

/// Pose, pedal and buttons of a device at one moment.
struct DeviceSample {
    Pose hand;         ///< pose of the tool tip in the device's frame: +x right, +y away from the user, +z up; mm
    double pedal = 0;  ///< 0 up .. 1 down
    std::uint32_t buttons = 0;    ///< bit i: button i is pressed. Pens: 0 = turbine or mirror, 1 = touch or cut
    bool connected = true;        ///< false: the other fields are invalid, and no force may be rendered
    double age = 0;               ///< s since the measurement by the device's time stamp, else since the sample arrived
    double motorTemperature = 0;  ///< as the device reports it, 0 cold .. 1 hot; 0 if it reports none
    bool isFresh = true;          ///< false: the same sample as at the last read
};

/// Is called at each new sample, by a thread of the device. It must not block.
struct SampleListener {
    void (*call)(void* context) = nullptr;  ///< nullptr: nobody listens
    void* context = nullptr;

    void operator()() const {
        if (call != nullptr) call(context);
    }
};

/// One device for one hand. A user with two hands uses two objects, each paired with an instrument.
///
/// Any single thread may call open and close. Only the servo thread calls read and write, in this order, once a tick:
/// they neither block, allocate, lock, log nor throw. Where a vendor delivers samples through its own callback, or one
/// reply for each message, the backend passes them to the servo thread.
class HapticDevice {
public:
    HapticDevice() = default;
    HapticDevice(const HapticDevice&) = delete;
    HapticDevice& operator=(const HapticDevice&) = delete;
    virtual ~HapticDevice() = default;

    [[nodiscard]] virtual const DeviceInfo& info() const = 0;

    /// Fails with one sentence that states the fault of the device and the remedy.
    [[nodiscard]] virtual Expected<void> open() = 0;
    virtual void close() = 0;

    /// `elapsed`: s since the last read.
    [[nodiscard]] virtual DeviceSample read(double elapsed) = 0;
    /// Whether the device sets the servo rate. waitForTick then returns when a new sample has arrived, or after
    /// `longest` s.
    [[nodiscard]] virtual bool drivesServoRate() const { return false; }
    virtual void waitForTick(double /*longest*/) {}
    /// For a caller that waits for other events than samples, too. Set it before open(). A device without a thread of
    /// its own, which is read at the pace of its caller, calls no listener.
    void setSampleListener(const SampleListener& listener) { sampleListener_ = listener; }

    /// While suspended, a device whose sticks and buttons also have another function treats them as released. Any
    /// thread.
    virtual void suspendInput(bool /*rests*/) {}

    /// The present fault and its remedy, one sentence; nullptr if there is none. Any thread. The message lives as long
    /// as the program.
    [[nodiscard]] virtual const Message* faultMessage() const { return poseMonitor_.faultMessage(); }

    /// Records the pose fault that the servo thread found at this tick, for faultMessage(). Servo thread only.
    void recordPoseFault(PoseFault fault, double elapsed) { poseMonitor_.update(fault, elapsed); }

    /// Accepts only a wrench that has passed the safety limiter. Force in the device's frame.
    virtual void write(const SafeWrench& wrench) = 0;

protected:
    [[nodiscard]] const SampleListener& sampleListener() const { return sampleListener_; }

private:
    PoseMonitor poseMonitor_;
    SampleListener sampleListener_;
};

}  // namespace tactooth
