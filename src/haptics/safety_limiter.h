// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "haptics/wrench.h"

namespace tactooth {

/// The largest forces, and the fastest changes of force, that a device may render.
struct ForceLimits {
    double force = 3.3;          ///< N; the peak force of a Touch
    double torque = 0;           ///< N*mm; 0: the device renders no torque
    double slew = 300;           ///< N/s: 0.3 N in a millisecond; the hand feels a steeper step as a kick
    double rampTime = 0.5;       ///< s from zero to full strength after a start
    double tickTimeout = 0.003;  ///< s without a tick after which the force starts from zero again
    /// N*mm/s: the slew rate of a force at a lever of 10 mm, from the tip of the bur to the fingers.
    double torqueSlew = 3000;
    double continuousForce = std::numeric_limits<double>::infinity();  ///< N that the motors can render without end
    double friction = 0;  ///< N, dry friction of the device's own mechanics
    /// N*mm/s (1e-3 W): the largest product of force and speed of the hand. The default is that of a Touch. `limitsOf`
    /// in devices/base/device_presets.h explains it.
    double power = 2296;
};

/// A wrench that the limiter has made. A device accepts no other, and no other class can make one.
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

/// The last stage before the motors. It bounds magnitude, slew rate and power, and ramps the force up after each start.
/// It gives zero for a wrench that is not finite, for a late tick, and while it is disabled.
class SafetyLimiter {
public:
    /// The limits are finite and not negative; `continuousForce` and `power` may be infinite.
    explicit SafetyLimiter(const ForceLimits& limits);

    /// Limits a wrench. `elapsed` is the time since the last call, s; `speed` is that of the hand, mm/s. The faster the
    /// hand moves, the less force the bound on power allows. The bound on power comes last, and may reduce a force
    /// faster than the slew rate.
    [[nodiscard]] SafeWrench limit(const Wrench& wanted, double elapsed, bool enabled, double speed);

    /// The share `left` (0..1) of an earlier wrench of this limiter, for a force that has to end sooner than the slew
    /// rate allows. The next force starts from zero, with the ramp. A share that is not a number counts as zero.
    [[nodiscard]] SafeWrench fade(const SafeWrench& earlier, double left);

    /// Number of ticks with an input that was not finite, or that came too late.
    [[nodiscard]] std::uint64_t faults() const { return faults_; }
    [[nodiscard]] const ForceLimits& limits() const { return limits_; }
    /// Progress of the ramp, 0..1.
    [[nodiscard]] double strength() const { return strength_; }

private:
    [[nodiscard]] bool isValid(const Wrench& wanted, double elapsed, double speed) const;
    void checkResult(const Wrench& before, double elapsed, double speed) const;

    ForceLimits limits_;
    Wrench last_;
    double strength_ = 0;  // of the ramp, 0..1
    std::uint64_t faults_ = 0;
};

}  // namespace tactooth
