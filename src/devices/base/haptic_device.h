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

/// What a device is and can do. Everything that differs between devices is a number here, so that nothing above this
/// layer asks which device it is.
struct DeviceInfo {
    std::string name;  ///< for people
    bool rendersForce = false;
    bool sensesRotation = false;
    int buttonCount = 0;
    bool hasPedal = false;
    ForceLimits limits;                   ///< that the safety limiter keeps to
    PoseLimits poseLimits;                ///< beyond which its readings are a fault
    Vec3 workspace = Vec3::Zero();        ///< size of the room that the hand can reach, mm; zero: not bounded
    std::optional<Vec3> workspaceCentre;  ///< of that room, in the device's frame, mm; none: not known
    bool isInToothFrame = false;          ///< its frame is the tooth's: it tells where the tool is, and needs no seat
    double stiffness =
        std::numeric_limits<double>::infinity();  ///< N/mm: the stiffest wall that does not shake, at 1 kHz
};

/// The stiffest wall that such a device renders at another rate: half as many ticks feed it twice the energy, so a wall
/// may be half as stiff (J. E. Colgate, G. Schenkel, "Passivity of a Class of Sampled-Data Systems", American Control
/// Conference 1994: b > k T / 2). More than 1 kHz is not trusted to bear more: the device's own mechanics bound it.
[[nodiscard]] inline double maxStiffnessAt(double stiffness, double rateHz) {
    return stiffness * std::min(1.0, rateHz / 1000);
}

/// The hand and the foot at one moment.
struct DeviceSample {
    Pose hand;         ///< of the tool's tip, in the device's frame: +x right, +y away from the user, +z up; mm
    double pedal = 0;  ///< 0 up .. 1 down
    std::uint32_t buttons = 0;    ///< bit i: button i is pressed. Pens: 0 = turbine or mirror, 1 = touch or cut
    bool connected = true;        ///< false: the other fields mean nothing, and no force may be made
    double age = 0;               ///< s since the device measured it, by its own time if it has one, else since it came
    double motorTemperature = 0;  ///< as the device reports it, 0 cold .. 1 hot; 0 if it reports none
    bool isFresh = true;          ///< not the one of the last read
};

/// One device for one hand. Two hands are two objects, each paired with an instrument.
///
/// open and close are called from any one thread. read and write are called by the servo thread alone, in turn, once a
/// tick: they neither block, allocate, lock, log nor throw. A vendor that delivers samples by a callback of its own, or
/// by one reply a message, hands them over inside the backend.
class HapticDevice {
public:
    HapticDevice() = default;
    HapticDevice(const HapticDevice&) = delete;
    HapticDevice& operator=(const HapticDevice&) = delete;
    virtual ~HapticDevice() = default;

    [[nodiscard]] virtual const DeviceInfo& info() const = 0;

    /// Fails with one sentence that says what is wrong with the device and what to do about it.
    [[nodiscard]] virtual Expected<void> open() = 0;
    virtual void close() = 0;

    /// `elapsed`: since the last read, s.
    [[nodiscard]] virtual DeviceSample read(double elapsed) = 0;
    /// Whether the device sets the pace; waitForTick then returns when it has a new sample, or after `longest` s.
    [[nodiscard]] virtual bool drivesServoRate() const { return false; }
    virtual void waitForTick(double /*longest*/) {}

    /// As long as it rests, a device whose sticks and buttons mean something else as well takes them for let go. Any
    /// thread.
    virtual void suspendInput(bool /*rests*/) {}

    /// What is wrong at the moment and what to do about it, one sentence; nullptr if nothing is. Any thread. The
    /// message lives as long as the program.
    [[nodiscard]] virtual const Message* faultMessage() const { return poseMonitor_.faultMessage(); }

    /// What the servo has found wrong with the hand at this tick, for faultMessage() to report. The servo's.
    void judge(PoseFault fault, double elapsed) { poseMonitor_.update(fault, elapsed); }

    /// Takes only what has passed the safety limiter. Force in the device's frame.
    virtual void write(const SafeWrench& wrench) = 0;

private:
    PoseMonitor poseMonitor_;
};

}  // namespace tactooth
