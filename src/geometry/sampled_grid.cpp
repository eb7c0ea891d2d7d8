// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/sampled_grid.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace tactooth {

SampledGrid::SampledGrid(const ScalarField& field, const Box3& box, const IsosurfaceOptions& options)
    : size_(options.cellSize) {
    const Vec3 low = box.min() / size_, high = box.max() / size_;
    origin_ = low.array().floor().cast<int>() - 1;
    const Index3 cells = Index3(high.array().ceil().cast<int>() + 1) - origin_;
    blocks_ = (cells.array() + kBlock - 1) / kBlock;
    points_ = blocks_ * kBlock + Index3::Ones();
    findActiveBlocks(field, options.steepest);
    sample(field);
}

Index3 SampledGrid::blockAt(std::size_t number) const {
    const auto x = static_cast<std::size_t>(blocks_.x()), y = static_cast<std::size_t>(blocks_.y());
    return {static_cast<int>(number % x), static_cast<int>(number / x % y), static_cast<int>(number / (x * y))};
}

void SampledGrid::findActiveBlocks(const ScalarField& field, double steepest) {
    active_.assign(static_cast<std::size_t>(blocks_.x()) * blocks_.y() * blocks_.z(), 0);
    const double reach = steepest * std::sqrt(3.0) / 2 * kBlock * size_;
    tbb::parallel_for(std::size_t{0}, active_.size(), [&](std::size_t number) {
        const Vec3 centre = position(blockAt(number) * kBlock) + Vec3::Constant(0.5 * kBlock * size_);
        active_[number] = std::abs(field(centre)) <= reach;
    });
}

/// A point is needed by every block that it is a corner, edge or face point of.
bool SampledGrid::isNeeded(const Index3& point) const {
    const Index3 high = (point / kBlock).cwiseMin(blocks_ - Index3::Ones());
    const Index3 low = (point - Index3::Ones()).cwiseMax(0) / kBlock;
    for (int z = low.z(); z <= high.z(); ++z) {
        for (int y = low.y(); y <= high.y(); ++y) {
            for (int x = low.x(); x <= high.x(); ++x) {
                if (isActive({x, y, z})) return true;
            }
        }
    }
    return false;
}

void SampledGrid::sample(const ScalarField& field) {
    values_.assign(static_cast<std::size_t>(points_.x()) * points_.y() * points_.z(), 1.0f);
    const int rows = points_.y();
    tbb::parallel_for(0, points_.y() * points_.z(), [&](int row) {
        for (Index3 point(0, row % rows, row / rows); point.x() < points_.x(); ++point.x()) {
            if (isNeeded(point)) values_[pointNumber(point)] = static_cast<float>(field(position(point)));
        }
    });
}

}  // namespace tactooth
