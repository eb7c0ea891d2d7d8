// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/pose.h"

namespace tactooth {

/// Why a reading of a device, or the force that was computed from it, is not usable.
enum class PoseFault {
    None,
    NotANumber,       ///< a position or rotation that is not finite
    InvalidRotation,  ///< a quaternion that is not of unit length
    Jump,             ///< a position that the hand cannot have reached in the time
    TooFast,          ///< faster than any hand that touches a tooth
    RotatesTooFast,   ///< faster than a wrist can rotate
    Stale,            ///< measured too long ago
    Force,            ///< the pose is valid, but the force, or its input, is not finite or is absurd
};

/// What a hand on a device can do. A reading beyond it is a fault. The defaults are for a hand that holds the arm of a
/// device.
struct PoseLimits {
    double freeJump = 5;          ///< mm; a step shorter than this plus `freeSpeed` times the time is not a jump
    double freeSpeed = 5000;      ///< mm/s: three times the speed of the fastest hand
    double jump = 2;              ///< mm between two readings in contact: a hand that slides over a tooth moves 0.2
    double speed = 1500;          ///< mm/s in contact: a tap arrives with 200, a slip with 500
    double maxAngularSpeed = 30;  ///< rad/s: a flick of the wrist reaches 20
    /// s between two readings of the rotation, if the device reads it less often than the position.
    double rotationPeriod = 0;
    double maxAge = 0.005;  ///< s, largest age of a reading

    /// For a device that no hand holds, such as a mouse, whose position may jump anywhere. Only a reading that is not
    /// finite is a fault.
    [[nodiscard]] static PoseLimits unlimited() {
        return {kUnlimited, kUnlimited, kUnlimited, kUnlimited, kUnlimited, 0, kUnlimited};
    }

private:
    static constexpr double kUnlimited = 1e9;  // finite: infinity times zero seconds is not a number
};

/// One reading of a device.
struct PoseReading {
    Vec3 position = Vec3::Zero();  ///< mm
    Quat rotation = Quat::Identity();
    double age = 0;       ///< s since the measurement
    bool isFresh = true;  ///< false: the same reading as a tick before
};

/// Checks the readings of a device, tick by tick. After a fault, the device must give valid readings for 0.1 s before
/// it counts as valid again. Meanwhile the limits of a tool in contact apply. Times are those of the measurements. A
/// quaternion and its negative are the same rotation. It allocates, locks and logs nothing.
class PoseValidator {
public:
    explicit PoseValidator(const PoseLimits& limits = {});

    /// The result that `take` would give. `elapsed`, s, and `touching` as there.
    [[nodiscard]] PoseFault check(const PoseReading& reading, double elapsed, bool touching) const;

    /// Takes the reading of a tick that came `elapsed` s after the last one. `touching`: the tool is in contact at this
    /// reading.
    PoseFault take(const PoseReading& reading, double elapsed, bool touching);

    /// The next reading may be anywhere: there was none for a while.
    void forget() { following_ = false; }

    /// Speed of the hand at the last reading, mm/s.
    [[nodiscard]] double speed() const { return speed_; }

private:
    [[nodiscard]] PoseFault find(const PoseReading& reading, double elapsed, bool touching) const;
    [[nodiscard]] PoseFault findMotion(const PoseReading& reading, double time, bool strict) const;
    [[nodiscard]] bool rotatesTooFast(const Quat& rotation, double time) const;
    [[nodiscard]] double faultHoldAfter(double elapsed) const;
    void follow(const PoseReading& reading, double time, bool anew);
    void followRotation(const Quat& rotation, double time, bool anew);

    PoseLimits limits_;
    double now_ = 0;          // s, time of the ticks
    bool following_ = false;  // false: there is no last reading
    bool touching_ = false;   // at the last tick
    Vec3 last_ = Vec3::Zero();
    double lastTime_ = 0;  // s, time of the measurement
    // A speed is measured over at least 0.9 ms, from these readings on.
    Vec3 anchor_ = Vec3::Zero();
    double anchorTime_ = 0;
    Quat rotation_ = Quat::Identity();
    double rotationTime_ = 0;
    double speed_ = 0;
    PoseFault fault_ = PoseFault::None;  // the last fault
    double faultHold_ = 0;               // s for which that fault still holds
};

}  // namespace tactooth
