// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/motor_thermal_model.h"

#include <algorithm>
#include <cmath>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kTimeConstant =
    60;                        // s, thermal time constant of a small motor's winding. Chosen: no maker publishes it
constexpr double kWarm = 0.8;  // temperature from which the force is reduced, so that the user does not feel a step

}  // namespace

MotorThermalModel::MotorThermalModel(double peak, double continuous) : peak_(peak), continuous_(continuous) {
    TACTOOTH_ASSERT(std::isfinite(peak) && peak >= 0);
    TACTOOTH_ASSERT(continuous > 0);
}

bool MotorThermalModel::add(double force, double elapsed, double reported) {
    if (!std::isfinite(force) || !std::isfinite(elapsed) || !std::isfinite(reported)) {
        modelled_ = heat_ = 1;
        return false;
    }
    TACTOOTH_ASSERT(force >= 0);
    TACTOOTH_ASSERT(elapsed >= 0);
    if (std::isfinite(continuous_)) {
        const double steady = force * force / (continuous_ * continuous_);
        modelled_ += (1 - std::exp(-elapsed / kTimeConstant)) * (steady - modelled_);
    }
    heat_ = std::max(modelled_, reported);
    TACTOOTH_ASSERT(modelled_ >= 0 && heat_ >= modelled_);
    return true;
}

double MotorThermalModel::bound() const {
    if (!(continuous_ < peak_)) return peak_;
    TACTOOTH_ASSERT(!std::isnan(heat_));
    const double share = std::clamp((1 - heat_) / (1 - kWarm), 0.0, 1.0);
    return std::min(peak_, continuous_ + share * (peak_ - continuous_));  // rounding may exceed the peak
}

}  // namespace tactooth
