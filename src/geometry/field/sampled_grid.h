// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/field/isosurface.h"
#include "geometry/util/assert.h"

namespace tactooth {

using Index3 = Eigen::Vector3i;  ///< index of a cell, a grid point or a block of cells

/// Values of a field at the corners of all grid cells that its surface may cross. Cells are grouped in blocks; a block
/// that the surface cannot reach is skipped.
class SampledGrid {
public:
    static constexpr int kBlock = 2;  ///< cells along a block; small, since evaluating the field is expensive

    SampledGrid(const ScalarField& field, const Box3& box, const IsosurfaceOptions& options);

    [[nodiscard]] const Index3& blocks() const { return blocks_; }
    [[nodiscard]] Index3 cells() const { return blocks_ * kBlock; }
    [[nodiscard]] bool isActive(const Index3& block) const { return active_[blockNumber(block)] != 0; }
    [[nodiscard]] Vec3 position(const Index3& point) const { return (point + origin_).cast<double>() * size_; }
    /// The value at a grid point. Defined at the corners of the cells of active blocks.
    [[nodiscard]] float value(const Index3& point) const { return values_[pointNumber(point)]; }

private:
    [[nodiscard]] std::size_t blockNumber(const Index3& b) const {
        TACTOOTH_ASSERT(b.minCoeff() >= 0 && (blocks_ - b).minCoeff() > 0);
        return (static_cast<std::size_t>(b.z()) * blocks_.y() + b.y()) * blocks_.x() + b.x();
    }
    [[nodiscard]] std::size_t pointNumber(const Index3& p) const {
        TACTOOTH_ASSERT(p.minCoeff() >= 0 && (points_ - p).minCoeff() > 0);
        return (static_cast<std::size_t>(p.z()) * points_.y() + p.y()) * points_.x() + p.x();
    }
    [[nodiscard]] Index3 blockAt(std::size_t number) const;
    void findActiveBlocks(const ScalarField& field, double lipschitzBound);
    [[nodiscard]] std::vector<std::uint8_t> neededPoints() const;
    void sample(const ScalarField& field);
    [[nodiscard]] bool isCrossed(const Index3& block, int axis, int side) const;
    bool followSurface();

    double size_;
    Index3 origin_, blocks_, points_;
    std::vector<std::uint8_t> active_;
    std::vector<float> values_;
};

}  // namespace tactooth
