// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/field/isosurface.h"

namespace tactooth {

using Index3 = Eigen::Vector3i;  ///< of a cell, a corner point or a block of cells

/// A field's values at the corners of all grid cells that its surface may cross. Cells are grouped in blocks; a block
/// that the surface cannot reach is skipped as a whole.
class SampledGrid {
public:
    static constexpr int kBlock = 2;  ///< cells along a block; small, since field values are dear

    SampledGrid(const ScalarField& field, const Box3& box, const IsosurfaceOptions& options);

    [[nodiscard]] const Index3& blocks() const { return blocks_; }
    [[nodiscard]] Index3 cells() const { return blocks_ * kBlock; }
    [[nodiscard]] bool isActive(const Index3& block) const { return active_[blockNumber(block)] != 0; }
    [[nodiscard]] Vec3 position(const Index3& point) const { return (point + origin_).cast<double>() * size_; }
    /// Defined at the corners of active blocks' cells.
    [[nodiscard]] float value(const Index3& point) const { return values_[pointNumber(point)]; }

private:
    [[nodiscard]] std::size_t blockNumber(const Index3& b) const {
        return (static_cast<std::size_t>(b.z()) * blocks_.y() + b.y()) * blocks_.x() + b.x();
    }
    [[nodiscard]] std::size_t pointNumber(const Index3& p) const {
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
