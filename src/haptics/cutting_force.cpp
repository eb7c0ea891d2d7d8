// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/cutting_force.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/util/assert.h"
#include "geometry/util/pose.h"

namespace tactooth {
namespace {

constexpr double kFullCuttingRpm = 3000;  // rev/min; a faster bur cuts with its full force
constexpr double kFade =
    0.02;  // s, time constant of the engagement: 1 N of normal force changes the pull by 0.025 N in a millisecond

// Hz; the frequency that a fingertip feels best is 200 to 300, and a turn has four ticks of 1 kHz.
constexpr double kMaxVibrationHz = 250;

}  // namespace

double CuttingForce::vibrationFrequency(double speedRpm, double freeSpeedRpm) {
    TACTOOTH_ASSERT(speedRpm >= 0);
    TACTOOTH_ASSERT(std::isfinite(freeSpeedRpm) && freeSpeedRpm >= 0);
    double frequency = speedRpm / 60;
    for (double free = freeSpeedRpm / 60; free > kMaxVibrationHz; free /= 2) frequency /= 2;
    return frequency;
}

Vec3 CuttingForce::at(const CuttingContact& contact, double dt) {
    TACTOOTH_ASSERT(dt >= 0);
    TACTOOTH_ASSERT(std::isfinite(contact.normalForce) && contact.normalForce >= 0);
    TACTOOTH_ASSERT(contact.normalForce == 0 || isUnit(contact.normal));
    TACTOOTH_ASSERT(isUnit(contact.axis));
    const double engagement =
        contact.normalForce > 0
            ? std::clamp((contact.speedRpm - kMinCuttingRpm) / (kFullCuttingRpm - kMinCuttingRpm), 0.0, 1.0)
            : 0;
    engagement_ += (1 - std::exp(-dt / kFade)) * (engagement - engagement_);
    TACTOOTH_ASSERT(engagement_ >= 0 && engagement_ <= 1);
    const double frequency = vibrationFrequency(contact.speedRpm, contact.freeSpeedRpm);
    phase_ = std::fmod(phase_ + 2 * std::numbers::pi * frequency * dt, 2 * std::numbers::pi);

    // The rim at the contact moves along axis x normal: seen from the shaft the bur turns clockwise, and the contact is
    // on the side away from the normal. Where a bur cuts with its end, the pulls around the axis cancel.
    const Vec3 pull = -kTangentialRatio * contact.axis.cross(contact.normal);
    const Vec3 any = std::abs(contact.axis.x()) < 0.7 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
    const Vec3 first = contact.axis.cross(any).normalized();
    const Vec3 vibration = kVibrationRatio * (std::cos(phase_) * first + std::sin(phase_) * contact.axis.cross(first));
    TACTOOTH_ASSERT(phase_ >= 0 && phase_ < 2 * std::numbers::pi);
    TACTOOTH_ASSERT((pull + vibration).norm() < 1.01 * (kTangentialRatio + kVibrationRatio));
    return engagement_ * contact.normalForce * (pull + vibration);
}

}  // namespace tactooth
