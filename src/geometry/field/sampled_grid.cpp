// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/field/sampled_grid.h"

#include <cmath>
#include <limits>

#include "geometry/util/assert.h"
#include "geometry/util/parallel_for.h"

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
    findActiveBlocks(field, options.lipschitzBound);
    values_.assign(static_cast<std::size_t>(points_.x()) * points_.y() * points_.z(), kUnknown);
    do {
        sample(field);
    } while (followSurface());
}

Index3 SampledGrid::blockAt(std::size_t number) const {
    TACTOOTH_ASSERT(number < active_.size());
    const auto x = static_cast<std::size_t>(blocks_.x()), y = static_cast<std::size_t>(blocks_.y());
    return {static_cast<int>(number % x), static_cast<int>(number / x % y), static_cast<int>(number / (x * y))};
}

/// From large cubes of blocks to single blocks: few values exclude what is far from the surface.
void SampledGrid::findActiveBlocks(const ScalarField& field, double lipschitzBound) {
    active_.assign(static_cast<std::size_t>(blocks_.x()) * blocks_.y() * blocks_.z(), 0);
    constexpr int kLargest = 8;  // blocks along a cube
    std::vector<Index3> cubes;
    for (int z = 0; z < blocks_.z(); z += kLargest) {
        for (int y = 0; y < blocks_.y(); y += kLargest) {
            for (int x = 0; x < blocks_.x(); x += kLargest) cubes.emplace_back(x, y, z);
        }
    }
    for (int side = kLargest; side > 0; side /= 2) {
        const double half = 0.5 * side * kBlock * size_, reach = lipschitzBound * std::sqrt(3.0) * half;
        std::vector<std::uint8_t> isNear(cubes.size());
        parallelFor(cubes.size(), [&](std::size_t i) {
            isNear[i] = std::abs(field(position(cubes[i] * kBlock) + Vec3::Constant(half))) <= reach;
        });
        std::vector<Index3> next;
        for (std::size_t i = 0; i < cubes.size(); ++i) {
            if (isNear[i] == 0) continue;
            if (side == 1) active_[blockNumber(cubes[i])] = 1;
            for (int child = 0; side > 1 && child < 8; ++child) {
                const Index3 at = cubes[i] + side / 2 * Index3(child & 1, (child >> 1) & 1, child >> 2);
                if ((blocks_ - at).minCoeff() > 0) next.push_back(at);
            }
        }
        cubes = std::move(next);
    }
}

/// The corners of all cells of active blocks.
std::vector<std::uint8_t> SampledGrid::neededPoints() const {
    std::vector<std::uint8_t> needed(values_.size(), 0);
    for (std::size_t number = 0; number < active_.size(); ++number) {
        if (active_[number] == 0) continue;
        const Index3 low = blockAt(number) * kBlock;
        for (int z = 0; z <= kBlock; ++z) {
            for (int y = 0; y <= kBlock; ++y) {
                const std::size_t row = pointNumber(low + Index3(0, y, z));
                for (int x = 0; x <= kBlock; ++x) needed[row + static_cast<std::size_t>(x)] = 1;
            }
        }
    }
    return needed;
}

void SampledGrid::sample(const ScalarField& field) {
    const std::vector<std::uint8_t> needed = neededPoints();
    const int rows = points_.y();
    parallelFor(static_cast<std::size_t>(rows) * points_.z(), [&](std::size_t number) {
        const int row = static_cast<int>(number);
        for (Index3 point(0, row % rows, row / rows); point.x() < points_.x(); ++point.x()) {
            const std::size_t at = pointNumber(point);
            if (needed[at] != 0 && std::isnan(values_[at])) values_[at] = static_cast<float>(field(position(point)));
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

/// A field steeper than its Lipschitz bound may hide a crossed block. Activates the neighbours into which the surface
/// continues, so that it never ends at an inactive block. Returns whether there were any.
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
