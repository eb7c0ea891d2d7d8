// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/distance_grid.h"

#include <algorithm>
#include <limits>

#include "collision/bvh/closest_point.h"
#include "geometry/util/assert.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

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

std::optional<GridSample> DistanceGrid::at(const Vec3& place) const {
    const Vec3 steps = (place - low) / spacing;
    const bool isWithin = (steps.array() >= 0).all() && (steps.array() < counts.cast<double>() - 1).all();
    if (!isWithin) return std::nullopt;  // also where it is no number
    const Eigen::Array3i cell = steps.array().floor().cast<int>();
    const Vec3 part = steps - cell.cast<double>().matrix();
    const auto valueAt = [&](int corner) {
        const auto x = static_cast<std::size_t>(cell.x() + (corner & 1));
        const auto y = static_cast<std::size_t>(cell.y() + (corner >> 1 & 1));
        const auto z = static_cast<std::size_t>(cell.z() + (corner >> 2 & 1));
        const auto nx = static_cast<std::size_t>(counts.x()), ny = static_cast<std::size_t>(counts.y());
        return static_cast<double>(values[x + nx * (y + ny * z)]);
    };
    GridSample sample{0, Vec3::Zero()};
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 weight, slope;  // of each axis
        for (int axis = 0; axis < 3; ++axis) {
            const bool isHigh = (corner >> axis & 1) != 0;
            weight[axis] = isHigh ? part[axis] : 1 - part[axis];
            slope[axis] = isHigh ? 1 : -1;
        }
        const double value = valueAt(corner);
        sample.distance += value * weight.prod();
        for (int axis = 0; axis < 3; ++axis)
            sample.gradient[axis] += value * slope[axis] * weight[(axis + 1) % 3] * weight[(axis + 2) % 3] / spacing;
    }
    return sample;
}

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

}  // namespace tactooth
