// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/distance_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "collision/bvh/closest_point.h"
#include "geometry/util/assert.h"
#include "geometry/util/parallel_for.h"

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

/// The signed distances of points in a row, `spacing` mm apart. Each says much about the next one: its distance differs
/// by the spacing at most, and both lie on the same side if one of them is farther from the surface than the spacing.
class RowSampler {
public:
    RowSampler(const SurfacePart& target, double spacing) : target_(target), reach_(kSlack * spacing) {}

    double next(const Vec3& point) {
        const bool isFirst = !distance_;
        const double within = isFirst ? std::numeric_limits<double>::infinity() : *distance_ + reach_;
        const auto closest = closestPoint(target_, point, within);
        TACTOOTH_ASSERT(closest.has_value());
        const bool isOnSameSide = !isFirst && std::max(*distance_, closest->distance) > reach_;
        if (!isOnSameSide) isInside_ = contains(target_, point);
        distance_ = closest->distance;
        return isInside_ ? -closest->distance : closest->distance;
    }

private:
    static constexpr double kSlack = 1.001;  // for rounding

    const SurfacePart& target_;
    double reach_;  // mm
    std::optional<double> distance_ = {};
    bool isInside_ = false;
};

}  // namespace

DistanceGrid sampleDistances(const SurfacePart& target, const Box3& box, int longest) {
    DistanceGrid grid;
    grid.low = box.min();
    grid.spacing = box.sizes().maxCoeff() / (longest - 1);
    grid.counts = (box.sizes().array() / grid.spacing).ceil().cast<int>() + 1;
    const int nx = grid.counts.x(), ny = grid.counts.y(),
              nz = grid.counts.z();  // clang 14: a lambda cannot capture structured bindings
    grid.values.resize(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz));
    const auto rows = static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz);
    parallelFor(rows, [&](std::size_t row) {
        const auto y = static_cast<double>(row % static_cast<std::size_t>(ny));
        const auto z = static_cast<double>(row / static_cast<std::size_t>(ny));
        float* const values = &grid.values[row * static_cast<std::size_t>(nx)];
        RowSampler sampler(target, grid.spacing);
        for (int x = 0; x < nx; ++x)
            values[x] = static_cast<float>(sampler.next(grid.low + grid.spacing * Vec3(x, y, z)));
    });
    return grid;
}

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
