// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/cutting_force.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactooth {
namespace {

constexpr double kFullCuttingRpm = 3000;  // rev/min; a faster one cuts with all its force
constexpr double kFade = 0.02;  // s; of the bite: 1 N of normal force brings the pull by 0.025 N a millisecond

// Hz; where a fingertip feels shaking best (200 to 300), and four ticks of 1 kHz a turn.
constexpr double kMaxVibrationHz = 250;

}  // namespace

double CuttingForce::vibrationFrequency(double speedRpm, double freeSpeedRpm) {
    double frequency = speedRpm / 60;
    for (double free = freeSpeedRpm / 60; free > kMaxVibrationHz; free /= 2) frequency /= 2;
    return frequency;
}

Vec3 CuttingForce::at(const CuttingContact& contact, double dt) {
    const double engagement =
        contact.normalForce > 0
            ? std::clamp((contact.speedRpm - kMinCuttingRpm) / (kFullCuttingRpm - kMinCuttingRpm), 0.0, 1.0)
            : 0;
    engagement_ += (1 - std::exp(-dt / kFade)) * (engagement - engagement_);
    const double frequency = vibrationFrequency(contact.speedRpm, contact.freeSpeedRpm);
    phase_ = std::fmod(phase_ + 2 * std::numbers::pi * frequency * dt, 2 * std::numbers::pi);

    // The rim at the contact moves along axis x normal: the shaft is seen turning clockwise, and the contact lies on
    // the side away from the normal. Where a bur cuts with its end, the pulls around the axis cancel.
    const Vec3 pull = -kTangentialRatio * contact.axis.cross(contact.normal);
    const Vec3 any = std::abs(contact.axis.x()) < 0.7 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
    const Vec3 first = contact.axis.cross(any).normalized();
    const Vec3 shake = kVibrationRatio * (std::cos(phase_) * first + std::sin(phase_) * contact.axis.cross(first));
    return engagement_ * contact.normalForce * (pull + shake);
}

}  // namespace tactooth
