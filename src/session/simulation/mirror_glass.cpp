// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/mirror_glass.h"

#include <algorithm>
#include <cmath>

namespace tactooth {

void MirrorGlass::advance(const Input& now, double dt) {
    const double more = std::max(0.0, now.ground - ground_.value_or(now.ground));
    ground_ = now.ground;
    if (!now.isInMouth) return;
    dirt_ = 1 - (1 - dirt_) * std::exp(-more / kSoils);
    breathed_ = std::clamp(breathed_ + (now.sprayRuns ? -dt * kFull / kRinses : dt), 0.0, kFull);
}

double MirrorGlass::fog() const {
    const double share = std::clamp((breathed_ - kBegins) / (kFull - kBegins), 0.0, 1.0);
    return share * share * (3 - 2 * share);
}

}  // namespace tactooth
