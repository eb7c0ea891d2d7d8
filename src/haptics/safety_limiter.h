// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "haptics/wrench.h"

namespace tactooth {

/// What a device may be asked for.
struct ForceLimits {
    double force = 3.3;          ///< N; the peak of a Touch
    double torque = 0;           ///< N*mm; 0: the device renders none
    double slew = 300;           ///< N/s: 0.3 N a millisecond, steeper steps feel like a kick (and are one)
    double rampTime = 0.5;       ///< s from zero to full strength after switching on
    double tickTimeout = 0.003;  ///< s without a tick after which the force starts from zero again
    double torqueSlew = 3000;    ///< N*mm/s: a force's slew on a lever of 10 mm, from the bur's tip to the fingers
    double continuousForce = std::numeric_limits<double>::infinity();  ///< N that the motors bear for ever
    double friction = 0;                                               ///< N, dry, of the device's own mechanics
    /// N*mm/s (1e-3 W): force times speed of the hand. The default is a Touch's; see limitsOf in
    /// devices/device_presets.h for what it comes from.
    double power = 2296;
};

/// A wrench that has passed the limiter: the only kind that a device accepts. Nothing else can make one.
class SafeWrench {
public:
    SafeWrench() = default;  ///< zero
    [[nodiscard]] const Vec3& force() const { return wrench_.force; }
    [[nodiscard]] const Vec3& torque() const { return wrench_.torque; }

private:
    friend class SafetyLimiter;
    explicit SafeWrench(const Wrench& wrench) : wrench_(wrench) {}
    Wrench wrench_;
};

/// The last stage before the motors. Bounds magnitude, slew and power, ramps up after every start, and gives zero for
/// anything that is not a number, for a tick that came too late, and while switched off.
class SafetyLimiter {
public:
    explicit SafetyLimiter(const ForceLimits& limits) : limits_(limits) {}

    /// `elapsed`: since the call before, s. `speed`: of the hand, mm/s: the quicker it is, the less force keeps within
    /// the power. That bound comes last, and may take a force back faster than the slew would.
    [[nodiscard]] SafeWrench limit(const Wrench& wanted, double elapsed, bool enabled, double speed);

    /// Ticks on which something other than the usual bounds was wrong: not a number, or too late.
    [[nodiscard]] std::uint64_t faults() const { return faults_; }
    [[nodiscard]] const ForceLimits& limits() const { return limits_; }
    /// How far the ramp has come, 0..1.
    [[nodiscard]] double strength() const { return strength_; }

private:
    [[nodiscard]] bool isValid(const Wrench& wanted, double elapsed, double speed) const;

    ForceLimits limits_;
    Wrench last_;
    double strength_ = 0;  // of the ramp, 0..1
    std::uint64_t faults_ = 0;
};

}  // namespace tactooth
