// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/passivity_controller.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/util/assert.h"

// B. Hannaford, J.-H. Ryu, "Time-Domain Passivity Control of Haptic Interfaces", IEEE Transactions on Robotics and
// Automation 18, 2002: an observer sums force times displacement, and a controller damps as soon as the sum is
// negative. As in J.-H. Ryu, C. Preusche, B. Hannaford, G. Hirzinger, "Time Domain Passivity Control with Reference
// Energy Following", IEEE Transactions on Control Systems Technology 13, 2005, the sum is compared with the energy that
// the spring stores. So the controller acts at the first tick that returns too much energy, and not only when all of
// the stored energy is gone.
//
// Ours differs in five points. The credit is bounded. The spring is cut off where the force of the device ends. The dry
// friction of the device counts (J. J. Abbott, A. M. Okamura, "Effects of Position Quantization and Sampling Rate on
// Virtual-Wall Passivity", IEEE Transactions on Robotics 21, 2005: without friction no wall is passive if the position
// is quantised). The damper is released slowly. It acts before the sum is negative, because its effect comes a tick
// later: the energy that the next step may leak is kept in reserve.

namespace tactooth {
namespace {

constexpr double kMaxCredit = 0.02;       // N*mm: minutes of rubbing must not permit a later oscillation
constexpr double kMaxDamping = 0.005;     // N*s/mm: ten times what sampling 1 N/mm at 1 kHz gives (k * T / 2)
constexpr double kTrustedFriction = 0.5;  // share of the maker's figure: friction varies from place to place
constexpr double kSpeedLag = 0.005;       // s, low-pass of the speed: a single encoder step is not a speed
constexpr double kStill = 1e-6;           // mm in a tick: a smaller displacement needs no damping
constexpr double kRelease =
    0.98;  // share of the damping that is left a tick later: the hand would feel a damper that flickers
constexpr double kOverdue = 2;  // step durations after which the hand counts as at rest

/// Energy of a spring whose force is cut off at a bound, N*mm.
double stored(const SpringState& spring, double deflection, double stiffness) {
    if (!(stiffness > 0) || !(deflection > 0)) return 0;
    const double soft = std::min(deflection, spring.bound / stiffness);
    return spring.strength * (0.5 * stiffness * soft * soft + spring.bound * (deflection - soft));
}

/// Energy that a step of that length leaks, N*mm: the force of the tick before is held during all of it.
double energyLeak(const SpringState& spring, double length) {
    return 0.5 * spring.strength * std::max(spring.stiffness, 0.0) * length * length;
}

}  // namespace

PassivityController::PassivityController(double friction) : friction_(friction) {
    TACTOOTH_ASSERT(std::isfinite(friction) && friction >= 0);
}

void PassivityController::reset() {
    started_ = false;
    energy_ = reserve_ = damping_ = 0;
    idle_ = pause_ = 0;
    speed_.setZero();
    step_.setZero();
}

/// A slow hand moves an encoder by one step in several ticks. Between two steps its speed is that of the last step,
/// until the next step is overdue.
void PassivityController::updateSpeed(const Vec3& displacement, double elapsed) {
    TACTOOTH_ASSERT(elapsed > 0);
    TACTOOTH_ASSERT(pause_ >= 0 && idle_ >= 0);
    idle_ += elapsed;
    if (displacement.norm() > kStill) {
        step_ = displacement;
        pause_ = std::exchange(idle_, 0);
    }
    const Vec3 speed = idle_ <= kOverdue * pause_ ? Vec3(step_ / std::max(pause_, idle_)) : Vec3(Vec3::Zero());
    speed_ += (1 - std::exp(-elapsed / kSpeedLag)) * (speed - speed_);
}

/// A sum that is NaN would stay NaN.
bool PassivityController::isValid() const {
    return std::isfinite(energy_) && std::isfinite(reserve_) && std::isfinite(damping_) && speed_.allFinite();
}

Vec3 PassivityController::damp(const Vec3& device, const Vec3& rendered, const SpringState& spring, double elapsed) {
    if (!std::exchange(started_, true) || !(elapsed > 0)) {
        lastDevice_ = device;
        lastDeflection_ = spring.deflection;
        lastStiffness_ = spring.stiffness;
        return Vec3::Zero();
    }
    const Vec3 displacement = device - lastDevice_;
    // Both states of the spring with the present bound and strength: the work of a ramp is intended and is not a leak.
    energy_ += -rendered.dot(displacement) -
               (stored(spring, spring.deflection, spring.stiffness) - stored(spring, lastDeflection_, lastStiffness_));
    lastDevice_ = device;
    lastDeflection_ = spring.deflection;
    lastStiffness_ = spring.stiffness;

    const double length = displacement.norm();
    energy_ = std::min(energy_ + kTrustedFriction * friction_ * length, kMaxCredit);
    updateSpeed(displacement, elapsed);
    reserve_ = std::max(kRelease * reserve_, energyLeak(spring, length));
    damping_ *= kRelease;
    const double missing = std::min(reserve_, kMaxCredit) - energy_;
    if (missing > 0 && length > kStill) damping_ = std::max(damping_, missing * pause_ / (length * length));
    damping_ = std::min(damping_, kMaxDamping);
    if (!isValid()) {
        reset();
        return Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    }
    TACTOOTH_ASSERT(energy_ <= kMaxCredit);
    TACTOOTH_ASSERT(reserve_ >= 0);
    TACTOOTH_ASSERT(damping_ >= 0 && damping_ <= kMaxDamping);
    return -damping_ * speed_;
}

}  // namespace tactooth
