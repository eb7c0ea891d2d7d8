// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/util/assert.h"
#include "geometry/util/vec.h"

namespace tactooth {

/// The outline of a plane or nearly plane face, projected along the axis that is closest to its normal, so that it runs
/// counter-clockwise. The projection drops one coordinate and leaves the others unchanged, so that the side of a line
/// that a corner is on is exact.
class ProjectedPolygon {
public:
    /// `corners` are numbers of `positions`, which must stay valid. `normal` is not zero.
    void set(std::span<const Vec3f> positions, std::span<const std::uint32_t> corners, const Vec3& normal);

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(corners_.size()); }
    /// The vertex of a corner: corners at the same position have the same vertex.
    [[nodiscard]] std::uint32_t vertex(std::uint32_t corner) const {
        TACTOOTH_ASSERT(corner < corners_.size());
        return corners_[corner];
    }
    [[nodiscard]] double x(std::uint32_t corner) const { return points_[corner].x(); }
    [[nodiscard]] double y(std::uint32_t corner) const { return points_[corner].y(); }

    /// Twice the signed area of a triangle of corners, rounded.
    [[nodiscard]] double doubledArea(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const Vec2 u = points_[b] - points_[a], v = points_[c] - points_[a];
        return u.x() * v.y() - u.y() * v.x();
    }
    /// Its exact sign: 1 if c is to the left of the line from a to b.
    [[nodiscard]] int side(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const Vec2 u = points_[b] - points_[a], v = points_[c] - points_[a];
        const double left = u.x() * v.y(), right = u.y() * v.x();
        constexpr double kFilter = 4.5e-16;  // Shewchuk's (3 + 16 e) e, e = 2^-53, rounded up
        const double bound = kFilter * (std::abs(left) + std::abs(right));
        if (left - right > bound) return 1;
        if (left - right < -bound) return -1;
        return exactSide(a, b, c);
    }
    [[nodiscard]] double squaredDistance(std::uint32_t a, std::uint32_t b) const {
        return (points_[b] - points_[a]).squaredNorm();
    }

    enum class Crossing { None, Found, NotKnown };
    /// Whether two edges cross properly: edges that only touch or overlap do not. Tests at most `maxTests` pairs of
    /// edges.
    [[nodiscard]] Crossing crossing(std::size_t maxTests) const;

private:
    [[nodiscard]] int exactSide(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
    [[nodiscard]] bool cross(std::uint32_t a, std::uint32_t c) const;
    [[nodiscard]] std::uint32_t after(std::uint32_t corner) const { return corner + 1 == size() ? 0 : corner + 1; }

    std::span<const Vec3f> positions_;
    std::vector<std::uint32_t> corners_;
    std::vector<Vec2> points_;
    int axis_ = 2;
    bool isMirrored_ = false;
};

}  // namespace tactooth
