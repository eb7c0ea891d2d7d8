// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/rumble_filter.h"

#include <cmath>

namespace tactooth {
namespace {

constexpr double kSteadyTime = 0.02;  // s: slower changes are steady force, quicker ones (from about 10 Hz) vibration
constexpr double kShakeTime = 0.03;   // s over which the vibration is averaged: gamepad motors take as long to start

}  // namespace

void RumbleFilter::add(const Vec3& force, double elapsed) {
    if (!force.allFinite() || !(elapsed > 0)) return;
    steady_ += (1 - std::exp(-elapsed / kSteadyTime)) * (force - steady_);
    square_ += (1 - std::exp(-elapsed / kShakeTime)) * ((force - steady_).squaredNorm() - square_);
}

double RumbleFilter::vibration() const { return std::sqrt(square_); }

}  // namespace tactooth
