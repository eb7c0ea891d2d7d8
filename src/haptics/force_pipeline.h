// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "haptics/haptic_simulation.h"
#include "haptics/motor_thermal_model.h"
#include "haptics/passivity_controller.h"
#include "haptics/pose_validator.h"
#include "haptics/safety_limiter.h"

namespace tactooth {

/// The force that the simulation computed for one tick, in the device's frame.
struct ForceCommand {
    Wrench wrench;
    Vec3 hand = Vec3::Zero();      ///< position that the device reports, of its tip, mm
    Quat turn = Quat::Identity();  ///< orientation that the device reports
    double age = 0;                ///< s since position and rotation were measured
    bool isFresh = true;           ///< false: the same reading as a tick before
    Vec3 driveForce =
        Vec3::Zero();       ///< the part of the force whose energy comes from the drive, N, not from the contact
    double deflection = 0;  ///< deflection of the contact spring, inwards and against friction, mm; 0 without contact
    double stiffness = 0;   ///< stiffness of the contact spring, N/mm
    bool touching = false;
    bool allowed = true;          ///< false: fade out, because the user switched the force off or the proxy is lost
    bool connected = true;        ///< false: the device is lost or its reading is wrong; zero force at once
    double motorTemperature = 0;  ///< as the device reports it, 0..1
};

/// The force of a tick, for a device whose frame is the tooth's.
[[nodiscard]] ForceCommand forceCommandFrom(const Tick& tick);

/// The state of the force output.
enum class ForceState {
    On,
    Off,              ///< switched off, or the proxy has no pose
    AwaitsFreeSpace,  ///< the force was switched on inside the tooth: zero until the tool has been in free space
    Warm,             ///< the motors are warm: strong forces are reduced to what the motors can bear
    Fault,            ///< the device is lost, or its pose or the force is faulty: see fault()
};

/// All stages from the force of the simulation to the motors, tick by tick. At a fault, and until the tool has been in
/// free space, the force is zero. Then come the passivity controller, the thermal model of the motors, and a bound on
/// how fast the force may change its direction. The safety limiter is last, directly before the motors. Equal calls
/// give equal results. It allocates, locks and logs nothing.
class ForcePipeline {
public:
    explicit ForcePipeline(const ForceLimits& limits, const PoseLimits& poseLimits = {});

    /// The fault of a reading of the device, `elapsed` s after the last one, as far as it is known before the
    /// simulation follows it.
    [[nodiscard]] PoseFault check(const PoseReading& reading, double elapsed) const {
        return validator_.check(reading, elapsed, false);
    }

    /// `elapsed` is the time since the last call, s. Bad input is a fault: it gives zero force in the same call.
    [[nodiscard]] SafeWrench pass(const ForceCommand& wanted, double elapsed);

    [[nodiscard]] ForceState state() const { return state_; }
    /// The fault of the last tick; not set if the device is lost.
    [[nodiscard]] PoseFault fault() const { return fault_; }
    [[nodiscard]] const PassivityController& passivity() const { return passivity_; }
    [[nodiscard]] const MotorThermalModel& heat() const { return heat_; }
    /// Number of ticks with a fault of the device or of the clock.
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
    Vec3 wallForceSent_ = Vec3::Zero();  // without the pull of the drive, N
    std::uint64_t faults_ = 0;
};

}  // namespace tactooth
