// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/passivity_controller.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

// B. Hannaford, J.-H. Ryu, "Time-Domain Passivity Control of Haptic Interfaces", IEEE Transactions on Robotics and
// Automation 18, 2002: an observer adds up force times way, a controller damps as soon as the sum is negative. As in
// J.-H. Ryu, C. Preusche, B. Hannaford, G. Hirzinger, "Time Domain Passivity Control with Reference Energy Following",
// IEEE Transactions on Control Systems Technology 13, 2005, the sum is held against the energy that the spring stores,
// so that it acts at the first tick that gives too much and not when all of the stored energy is gone. Differs: credit
// is bounded, the spring is cut off where the device's force ends, the device's dry friction pays (J. J. Abbott, A. M.
// Okamura, "Effects of Position Quantization and Sampling Rate on Virtual-Wall Passivity", IEEE Transactions on
// Robotics 21, 2005: without it no wall that is read in steps is passive), a damper that is needed goes off slowly, and
// it comes on before the sum is negative, because it acts a tick later: what the next step may leak is kept in reserve.

namespace tactooth {
namespace {

constexpr double kMaxCredit = 0.02;       // N*mm: rubbing for minutes must not pay for a shake later
constexpr double kMaxDamping = 0.005;     // N*s/mm: ten times what sampling 1 N/mm at 1 kHz gives (k * T / 2)
constexpr double kTrustedFriction = 0.5;  // of what the maker says: it differs from place to place
constexpr double kSpeedLag = 0.005;       // s: an encoder's single step is no speed
constexpr double kStill = 1e-6;           // mm in a tick: less is no motion to damp
constexpr double kRelease = 0.98;         // of the damping is left a tick later: a damper that flickers would be felt
constexpr double kOverdue = 2;            // pauses between two steps, after which the hand is taken to rest

/// Energy of the spring, N*mm; its force is cut off at a bound.
double stored(const SpringState& spring, double deflection, double stiffness) {
    if (!(stiffness > 0) || !(deflection > 0)) return 0;
    const double soft = std::min(deflection, spring.bound / stiffness);
    return spring.strength * (0.5 * stiffness * soft * soft + spring.bound * (deflection - soft));
}

/// What a step of that length leaks, N*mm: the force of the tick before is held through all of it.
double energyLeak(const SpringState& spring, double length) {
    return 0.5 * spring.strength * std::max(spring.stiffness, 0.0) * length * length;
}

}  // namespace

void PassivityController::reset() {
    started_ = false;
    energy_ = reserve_ = damping_ = 0;
    idle_ = pause_ = 0;
    speed_.setZero();
    step_.setZero();
}

/// A slow hand moves an encoder by a step every few ticks: between two of them its speed is that of the last one, until
/// the next is overdue.
void PassivityController::updateSpeed(const Vec3& displacement, double elapsed) {
    idle_ += elapsed;
    if (displacement.norm() > kStill) {
        step_ = displacement;
        pause_ = std::exchange(idle_, 0);
    }
    const Vec3 speed = idle_ <= kOverdue * pause_ ? Vec3(step_ / std::max(pause_, idle_)) : Vec3(Vec3::Zero());
    speed_ += (1 - std::exp(-elapsed / kSpeedLag)) * (speed - speed_);
}

/// Sums that are no number would stay so for ever.
bool PassivityController::isValid() const {
    return std::isfinite(energy_) && std::isfinite(reserve_) && std::isfinite(damping_) && speed_.allFinite();
}

Vec3 PassivityController::damp(const Vec3& hand, const Vec3& rendered, const SpringState& spring, double elapsed) {
    if (!std::exchange(started_, true) || !(elapsed > 0)) {
        lastDevice_ = hand;
        lastDeflection_ = spring.deflection;
        lastStiffness_ = spring.stiffness;
        return Vec3::Zero();
    }
    const Vec3 displacement = hand - lastDevice_;
    // Both states of the spring under today's bound and strength: what a ramp does is meant, and no leak.
    energy_ += -rendered.dot(displacement) -
               (stored(spring, spring.deflection, spring.stiffness) - stored(spring, lastDeflection_, lastStiffness_));
    lastDevice_ = hand;
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
    return -damping_ * speed_;
}

}  // namespace tactooth
