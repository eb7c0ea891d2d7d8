// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/position_rounding.h"

namespace tactooth {
std::optional<Vec3> PositionRounding::betterOffset() const {
    constexpr double kHarm = 1.0 / 40000;  // share of the longest side
    const Vec3 size = high_ - low_;
    const double longest = size.maxCoeff();
    if (isMoved_ || !std::isfinite(longest) || !(longest > 0) || !(loss_ > kHarm * longest)) return std::nullopt;
    // A short number: the middle of the box, rounded to a power of ten that is no longer than the surface.
    const double step = std::pow(10, std::floor(std::log10(longest)));
    Vec3 offset = 0.5 * (low_ + high_);
    for (double& coordinate : offset) coordinate = std::round(coordinate / step) * step;
    return offset.allFinite() && !offset.isZero(0) ? std::optional(offset) : std::nullopt;
}

}  // namespace tactooth
