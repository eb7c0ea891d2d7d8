// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/sampled_grid.h"

#include <cmath>
#include <limits>

#include "geometry/parallel_for.h"

namespace tactooth {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

}  // namespace

SampledGrid::SampledGrid(const ScalarField& field, const Box3& box, const IsosurfaceOptions& options)
    : size_(options.cellSize) {
    const Vec3 low = box.min() / size_, high = box.max() / size_;
    origin_ = low.array().floor().cast<int>() - 1;
    const Index3 cells = Index3(high.array().ceil().cast<int>() + 1) - origin_;
    blocks_ = (cells.array() + kBlock - 1) / kBlock;
    points_ = blocks_ * kBlock + Index3::Ones();
    findActiveBlocks(field, options.steepest);
    values_.assign(static_cast<std::size_t>(points_.x()) * points_.y() * points_.z(), kUnknown);
    do {
        sample(field);
    } while (followSurface());
}

Index3 SampledGrid::blockAt(std::size_t number) const {
    const auto x = static_cast<std::size_t>(blocks_.x()), y = static_cast<std::size_t>(blocks_.y());
    return {static_cast<int>(number % x), static_cast<int>(number / x % y), static_cast<int>(number / (x * y))};
}

void SampledGrid::findActiveBlocks(const ScalarField& field, double steepest) {
    active_.assign(static_cast<std::size_t>(blocks_.x()) * blocks_.y() * blocks_.z(), 0);
    const double reach = steepest * std::sqrt(3.0) / 2 * kBlock * size_;
    parallelFor(active_.size(), [&](std::size_t number) {
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
    const int rows = points_.y();
    parallelFor(static_cast<std::size_t>(rows) * points_.z(), [&](std::size_t number) {
        const int row = static_cast<int>(number);
        for (Index3 point(0, row % rows, row / rows); point.x() < points_.x(); ++point.x()) {
            float& value = values_[pointNumber(point)];
            if (std::isnan(value) && isNeeded(point)) value = static_cast<float>(field(position(point)));
        }
    });
}

/// True if the surface crosses the side `side` (0 low, 1 high) of a block along `axis`.
bool SampledGrid::isCrossed(const Index3& block, int axis, int side) const {
    Index3 point = block * kBlock;
    point[axis] += side * kBlock;
    const bool inside = value(point) < 0;
    for (int i = 0; i < (kBlock + 1) * (kBlock + 1); ++i) {
        Index3 other = point;
        other[(axis + 1) % 3] += i % (kBlock + 1);
        other[(axis + 2) % 3] += i / (kBlock + 1);
        if ((value(other) < 0) != inside) return true;
    }
    return false;
}

/// A field that is not as flat as promised may hide a crossed block: wakes the neighbours into which the surface
/// goes on, so that it never ends at a sleeping block. Returns whether there were any.
bool SampledGrid::followSurface() {
    std::vector<std::uint8_t> awake = active_;
    for (std::size_t number = 0; number < active_.size(); ++number) {
        if (active_[number] == 0) continue;
        const Index3 block = blockAt(number);
        for (int face = 0; face < 6; ++face) {
            Index3 next = block;
            next[face / 2] += face % 2 == 0 ? -1 : 1;
            const bool exists = next.minCoeff() >= 0 && (blocks_ - next).minCoeff() > 0;
            if (exists && !isActive(next) && isCrossed(block, face / 2, face % 2)) awake[blockNumber(next)] = 1;
        }
    }
    const bool any = awake != active_;
    active_.swap(awake);
    return any;
}

}  // namespace tactooth
