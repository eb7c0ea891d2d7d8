// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/rumble_filter.h"

#include <cmath>

namespace tactooth {
namespace {

constexpr double kSteadyTime = 0.02;  // s: slower changes press, quicker ones (from some 10 Hz on) shake
constexpr double kShakeTime = 0.03;   // s over which shaking is averaged: motors of pads take as long to start

}  // namespace

void RumbleFilter::add(const Vec3& force, double elapsed) {
    if (!force.allFinite() || !(elapsed > 0)) return;
    steady_ += (1 - std::exp(-elapsed / kSteadyTime)) * (force - steady_);
    square_ += (1 - std::exp(-elapsed / kShakeTime)) * ((force - steady_).squaredNorm() - square_);
}

double RumbleFilter::vibration() const { return std::sqrt(square_); }

}  // namespace tactooth
