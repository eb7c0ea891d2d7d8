// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/distance_colour.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/util/assert.h"

namespace tactooth {

namespace {

/// Evenly spaced from -1 to 1, sRGB.
const std::array<Vec3f, 7> kStops = {{{0.50F, 0.23F, 0.03F},
                                      {0.88F, 0.51F, 0.08F},
                                      {0.99F, 0.80F, 0.58F},
                                      {0.97F, 0.97F, 0.97F},
                                      {0.70F, 0.82F, 0.93F},
                                      {0.26F, 0.55F, 0.79F},
                                      {0.03F, 0.19F, 0.42F}}};

}  // namespace

double DistanceScale::shareOf(double distance) const {
    TACTOOTH_ASSERT(range > 0 && tolerance >= 0 && tolerance < range);
    if (tolerance == 0) return std::clamp(distance / range, -1.0, 1.0);
    const double beyond = (std::abs(distance) - tolerance) / (range - tolerance);
    if (beyond <= 0) return 0;
    return std::copysign(std::min(1.0, kToleranceStep + (1 - kToleranceStep) * beyond), distance);
}

Vec3f distanceColour(double share) {
    const double place = (std::clamp(share, -1.0, 1.0) + 1) / 2 * (kStops.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
    const auto part = static_cast<float>(place - static_cast<double>(below));
    return (1 - part) * kStops[below] + part * kStops[below + 1];
}

}  // namespace tactooth
