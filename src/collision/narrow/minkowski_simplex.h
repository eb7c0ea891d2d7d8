// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/util/vec.h"

namespace tactooth {

/// A corner of the difference b - a of two convex sets, and which corners of a and b it comes from.
struct MinkowskiPoint {
    Vec3 point;
    int onA;
    int onB;
};

/// One to four corners of a difference, reduced after each search to those that carry its point nearest to the origin.
class MinkowskiSimplex {
public:
    void add(const MinkowskiPoint& point) { points_[size_++] = point; }
    [[nodiscard]] int size() const { return size_; }
    [[nodiscard]] const MinkowskiPoint& point(int i) const { return points_[i]; }
    [[nodiscard]] double weight(int i) const { return weights_[i]; }
    [[nodiscard]] Vec3 edge(int from, int to) const { return points_[to].point - points_[from].point; }
    [[nodiscard]] bool holds(const MinkowskiPoint& other) const;

    /// The point of the simplex nearest to the origin. Drops every corner that does not carry it; a tetrahedron stays
    /// whole only if the origin is inside, and the answer is then the origin.
    [[nodiscard]] Vec3 nearestToOrigin();

private:
    std::array<MinkowskiPoint, 4> points_;
    std::array<double, 4> weights_{1, 0, 0, 0};
    int size_ = 0;
};

}  // namespace tactooth
