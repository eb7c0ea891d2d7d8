// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/pose.h"

namespace tactooth {

/// What is wrong with what a device tells of its hand, or with the force that came of it.
enum class PoseFault {
    None,
    NotANumber,       ///< a place or turn that is no number
    InvalidRotation,  ///< four numbers that are no turn
    Jump,             ///< a place where the hand cannot have come within the time
    TooFast,          ///< faster than any hand that touches a tooth
    RotatesTooFast,   ///< faster than a wrist
    Stale,            ///< measured too long ago
    Force,            ///< the pose is sound, but the force or what it was computed from is no number, or absurd
};

/// What a hand on a device can do; more is a fault of the reading. The defaults are those of a hand that holds an arm.
struct PoseLimits {
    double freeJump = 5;      ///< mm, plus `freeSpeed` times the time: less is no jump
    double freeSpeed = 5000;  ///< mm/s: three times the quickest of hands
    double jump = 2;          ///< mm between two readings, while it touches: a hand that slides over a tooth makes 0.2
    double speed = 1500;      ///< mm/s while it touches: a tap comes with 200, a slip with 500
    double maxAngularSpeed = 30;  ///< rad/s: a wrist that is flicked makes 20
    double rotationPeriod = 0;    ///< s between two readings of the turn, if it is read less often than the place
    double maxAge = 0.005;        ///< s since a reading was measured

    /// For a device that no hand is tied to, as a mouse, whose place may be put anywhere: only what is no number is a
    /// fault.
    [[nodiscard]] static PoseLimits unlimited() {
        return {kUnlimited, kUnlimited, kUnlimited, kUnlimited, kUnlimited, 0, kUnlimited};
    }

private:
    static constexpr double kUnlimited = 1e9;  // finite: infinity times no time is no number
};

/// One reading of a device.
struct PoseReading {
    Vec3 position = Vec3::Zero();  ///< mm
    Quat rotation = Quat::Identity();
    double age = 0;       ///< s since it was measured
    bool isFresh = true;  ///< not the one of the tick before
};

/// Judges what a device tells of the hand, tick by tick. After a fault it takes a tenth of a second of sound readings
/// until the device is believed again; meanwhile it is held to the limits of a tool that touches. Times are those at
/// which the readings were measured. A quaternion and its negative are the same turn. Allocates, locks and logs
/// nothing.
class PoseValidator {
public:
    explicit PoseValidator(const PoseLimits& limits = {}) : limits_(limits) {}

    /// What take() would say.
    [[nodiscard]] PoseFault judge(const PoseReading& reading, double elapsed, bool touching) const;

    /// Takes the reading of a tick that came `elapsed` s after the one before. `touching`: the tool touches with it.
    PoseFault take(const PoseReading& reading, double elapsed, bool touching);

    /// The next reading may be anywhere: there was none for a while.
    void forget() { following_ = false; }

    /// Of the hand at the last reading, mm/s.
    [[nodiscard]] double speed() const { return speed_; }

private:
    [[nodiscard]] PoseFault find(const PoseReading& reading, double elapsed, bool touching) const;
    [[nodiscard]] PoseFault findMotion(const PoseReading& reading, double time, bool strict) const;
    [[nodiscard]] bool rotatesTooFast(const Quat& rotation, double time) const;
    [[nodiscard]] double faultHoldAfter(double elapsed) const;
    void follow(const PoseReading& reading, double time, bool anew);
    void followRotation(const Quat& rotation, double time, bool anew);

    PoseLimits limits_;
    double now_ = 0;          // s, of the ticks
    bool following_ = false;  // what follows means something
    bool touching_ = false;   // at the last tick
    Vec3 last_ = Vec3::Zero();
    double lastTime_ = 0;  // s, at which it was measured
    // Speeds are taken over no less than most of a millisecond, from these readings on.
    Vec3 anchor_ = Vec3::Zero();
    double anchorTime_ = 0;
    Quat rotation_ = Quat::Identity();
    double rotationTime_ = 0;
    double speed_ = 0;
    PoseFault fault_ = PoseFault::None;  // the last one
    double faultHold_ = 0;               // s that it is still upheld
};

}  // namespace tactooth
