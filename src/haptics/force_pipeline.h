// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "haptics/haptic_simulation.h"
#include "haptics/motor_thermal_model.h"
#include "haptics/passivity_controller.h"
#include "haptics/pose_validator.h"
#include "haptics/safety_limiter.h"

namespace tactooth {

/// What the simulation wants the hand to feel at one tick, in the device's frame.
struct ForceCommand {
    Wrench wrench;
    Vec3 hand = Vec3::Zero();        ///< of the device's tip, mm
    Quat turn = Quat::Identity();    ///< of the hand on it
    double age = 0;                  ///< s since both were measured
    bool isFresh = true;             ///< they are not those of the tick before
    Vec3 driveForce = Vec3::Zero();  ///< that part of the force for which the drive pays, N: no energy of the wall's
    double deflection = 0;           ///< of the spring that pushes, inwards and against friction, mm; 0 without contact
    double stiffness = 0;            ///< of the spring that pushes, N/mm
    bool touching = false;
    bool allowed = true;          ///< false: fade out, as a person or the loss of the proxy asks for
    bool connected = true;        ///< false: the device is gone or its reading is wrong; nothing at once
    double motorTemperature = 0;  ///< as the device reports it, 0..1
};

/// What a tick wants, for a device whose frame is the tooth's.
[[nodiscard]] ForceCommand forceCommandFrom(const Tick& tick);

/// Why the hand feels what it feels.
enum class ForceState {
    On,
    Off,              ///< switched off, or no place of the tool is known
    AwaitsFreeSpace,  ///< came on inside the tooth: nothing until the tool has left it
    Warm,             ///< the motors are warm, and strong forces are cut to what they bear
    Fault,            ///< the device is lost, or something is wrong with its pose or with the force: see fault()
};

/// The way from the simulation's force to the motors, tick by tick: nothing at a fault or while the hand came into the
/// tooth without a force, then the passivity controller, the motors' heat, a bound on how fast the force may turn, and
/// last, alone before the motors, the safety limiter. Equal calls give equal results; allocates, locks and logs
/// nothing.
class ForcePipeline {
public:
    explicit ForcePipeline(const ForceLimits& limits, const PoseLimits& poseLimits = {});

    /// What is wrong with a reading, as far as it is known before the simulation has followed it.
    [[nodiscard]] PoseFault judge(const PoseReading& reading, double elapsed) const {
        return validator_.judge(reading, elapsed, false);
    }

    /// `elapsed`: since the call before, s.
    [[nodiscard]] SafeWrench pass(const ForceCommand& wanted, double elapsed);

    [[nodiscard]] ForceState state() const { return state_; }
    /// What was wrong at the last tick, apart from a device that is lost.
    [[nodiscard]] PoseFault fault() const { return fault_; }
    [[nodiscard]] const PassivityController& passivity() const { return passivity_; }
    [[nodiscard]] const MotorThermalModel& heat() const { return heat_; }
    /// Ticks at which the device or the clock was at fault.
    [[nodiscard]] std::uint64_t faults() const { return limiter_.faults() + faults_; }

private:
    [[nodiscard]] bool isFault(const ForceCommand& wanted, double elapsed);
    [[nodiscard]] SafeWrench stop(const ForceCommand& wanted, double elapsed);
    [[nodiscard]] SafeWrench rest(const ForceCommand& wanted, double elapsed);
    SafeWrench send(const Wrench& wrench, const ForceCommand& wanted, double elapsed);
    [[nodiscard]] Vec3 damping(const Vec3& force, const ForceCommand& wanted, double elapsed);
    [[nodiscard]] Vec3 wallForceSent(const Vec3& force, const Vec3& driveForce) const;
    [[nodiscard]] Vec3 directionLimited(const Vec3& force, double elapsed) const;

    [[nodiscard]] SafeWrench push(const ForceCommand& wanted, double elapsed);

    PoseValidator validator_;
    SafetyLimiter limiter_;
    MotorThermalModel heat_;
    PassivityController passivity_;
    ForceState state_ = ForceState::Off;
    bool awaitsFreeSpace_ = true;
    PoseFault fault_ = PoseFault::None;
    SafeWrench sent_;
    Vec3 wallForceSent_ = Vec3::Zero();  // without what the drive pulls, N
    std::uint64_t faults_ = 0;
};

}  // namespace tactooth
