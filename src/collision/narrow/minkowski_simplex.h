// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/util/assert.h"
#include "geometry/util/vec.h"

namespace tactooth {

/// A corner of the Minkowski difference b - a of two convex sets, and the corners of a and b that it comes from.
struct MinkowskiPoint {
    Vec3 point;
    int onA;
    int onB;
};

/// One to four corners of a Minkowski difference. Each search reduces them to those whose hull holds the point nearest
/// to the origin.
class MinkowskiSimplex {
public:
    void add(const MinkowskiPoint& point) {
        TACTOOTH_ASSERT(size_ < 4);
        points_[size_++] = point;
    }
    [[nodiscard]] int size() const { return size_; }
    [[nodiscard]] const MinkowskiPoint& point(int i) const {
        TACTOOTH_ASSERT(i >= 0 && i < size_);
        return points_[i];
    }
    /// Barycentric coordinate of the nearest point, 0 to 1.
    [[nodiscard]] double weight(int i) const {
        TACTOOTH_ASSERT(i >= 0 && i < size_);
        return weights_[i];
    }
    [[nodiscard]] Vec3 edge(int from, int to) const { return points_[to].point - points_[from].point; }
    /// Whether a corner is one of the simplex.
    [[nodiscard]] bool holds(const MinkowskiPoint& other) const;

    /// The point of the simplex nearest to the origin. Drops the corners that it does not need. A tetrahedron stays
    /// whole only if the origin is inside; the result is then the origin.
    [[nodiscard]] Vec3 nearestToOrigin();

private:
    std::array<MinkowskiPoint, 4> points_;
    std::array<double, 4> weights_{1, 0, 0, 0};
    int size_ = 0;
};

}  // namespace tactooth
