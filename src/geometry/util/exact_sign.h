// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "geometry/util/vec.h"

namespace tactooth {

/// The plane through three points, for tests against several other points.
class ExactPlane {
public:
    ExactPlane(const Vec3f& a, const Vec3f& b, const Vec3f& c) : corner_{a, b, c} {
        const Numbers u = {double{b.x()} - a.x(), double{b.y()} - a.y(), double{b.z()} - a.z()};
        const Numbers v = {double{c.x()} - a.x(), double{c.y()} - a.y(), double{c.z()} - a.z()};
        const auto set = [](double one, double other, double& difference, double& sizes) {
            difference = one - other;
            sizes = std::abs(one) + std::abs(other);
        };
        set(u.y * v.z, u.z * v.y, normal_.x, permanent_.x);
        set(u.z * v.x, u.x * v.z, normal_.y, permanent_.y);
        set(u.x * v.y, u.y * v.x, normal_.z, permanent_.z);
    }

    /// Exact sign (-1, 0, 1) of det[b - a, c - a, d - a]: positive if d is on the side that (b - a) x (c - a) points
    /// to.
    [[nodiscard]] int sideOf(const Vec3f& d) const {
        const double x = double{d.x()} - corner_[0].x();
        const double y = double{d.y()} - corner_[0].y();
        const double z = double{d.z()} - corner_[0].z();
        const double determinant = normal_.x * x + normal_.y * y + normal_.z * z;
        constexpr double kFilter = 16 * 2.220446049250313e-16;  // twice the largest rounding error of this evaluation
        const double bound =
            kFilter * (permanent_.x * std::abs(x) + permanent_.y * std::abs(y) + permanent_.z * std::abs(z));
        if (determinant > bound) return 1;
        if (determinant < -bound) return -1;
        return exactSideOf(d);
    }

private:
    /// Scalars, because they are used one by one: to assemble vector registers would cost more.
    struct Numbers {
        double x, y, z;
    };
    [[nodiscard]] int exactSideOf(const Vec3f& d) const;

    std::array<Vec3f, 3> corner_;
    Numbers normal_;
    Numbers permanent_;  // the same sum as `normal_`, of absolute values
};

/// The exact sign of det[b - a, c - a, d - a], as of ExactPlane: on which side of the plane a, b, c the point d lies.
[[nodiscard]] inline int orientationSign(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d) {
    return ExactPlane(a, b, c).sideOf(d);
}

/// Exact sign of component `axis` (0..2) of (b - a) x (d - c).
[[nodiscard]] int crossProductSign(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d, int axis);

}  // namespace tactooth
