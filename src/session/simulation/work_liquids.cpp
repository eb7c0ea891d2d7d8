// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/work_liquids.h"

#include <algorithm>
#include <cmath>

namespace tactooth {

void WorkLiquids::advance(const SprayInput& now, const std::optional<Vec3>& opening, double dt) {
    const double ground = total(now.ground);
    const double more = std::max(0.0, ground - ground_.value_or(ground));  // less: after an undo, or another tooth
    ground_ = ground;
    const bool isRunning = now.water > 0;
    if (isRunning) {
        spot_ = now.toolInTooth.position;
        slurry_ *= std::exp(-dt / kRinses);
        slurry_ += (1 - slurry_) * (1 - std::exp(-more / kMilky));
    }
    const double fallen = std::max(now.water, water_ - dt / kDries);
    const double risen = now.water + (water_ - now.water) * std::exp(-dt / kWets);
    water_ = water_ > now.water ? fallen : risen;
    if (water_ == 0) slurry_ = 0;
    if (!opening) {
        blood_ = 0;
        return;
    }
    opening_ = *opening;
    blood_ = isRunning ? blood_ * std::exp(-dt / kWashes) : 1 - (1 - blood_) * std::exp(-dt / kBleeds);
}

}  // namespace tactooth
