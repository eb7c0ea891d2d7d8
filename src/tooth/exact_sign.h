// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/vec.h"

namespace tactooth {

/// The plane through three points, to be asked about several others.
class ExactPlane {
public:
    ExactPlane(const Vec3f& a, const Vec3f& b, const Vec3f& c);

    /// Exact sign (-1, 0, 1) of det[b - a, c - a, d - a]: positive if d lies on the side to which (b - a) x (c - a)
    /// points.
    [[nodiscard]] int sideOf(const Vec3f& d) const;

private:
    std::array<Vec3f, 3> corner_;
    Vec3 normal_;
    Vec3 permanent_;  // the same sum as `normal_`, of absolute values
};

/// The side of the plane a, b, c on which d lies.
[[nodiscard]] inline int orientationSign(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d) {
    return ExactPlane(a, b, c).sideOf(d);
}

/// Exact sign of component `axis` of (b - a) x (d - c).
[[nodiscard]] int crossProductSign(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d, int axis);

}  // namespace tactooth
