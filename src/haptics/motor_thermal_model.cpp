// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/motor_thermal_model.h"

#include <algorithm>
#include <cmath>

namespace tactooth {
namespace {

constexpr double kTimeConstant = 60;  // s in which a small motor's winding takes its heat. Chosen: no maker tells it
constexpr double kWarm = 0.8;         // heat from which the force is taken back, so that no one feels it go at once

}  // namespace

bool MotorThermalModel::add(double force, double elapsed, double reported) {
    if (!std::isfinite(force) || !std::isfinite(elapsed) || !std::isfinite(reported)) {
        modelled_ = heat_ = 1;
        return false;
    }
    if (std::isfinite(continuous_)) {
        const double aim = force * force / (continuous_ * continuous_);
        modelled_ += (1 - std::exp(-elapsed / kTimeConstant)) * (aim - modelled_);
    }
    heat_ = std::max(modelled_, reported);
    return true;
}

double MotorThermalModel::bound() const {
    if (!(continuous_ < peak_)) return peak_;
    const double part = std::clamp((1 - heat_) / (1 - kWarm), 0.0, 1.0);
    return continuous_ + part * (peak_ - continuous_);
}

}  // namespace tactooth
