// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "geometry/util/vec.h"

namespace tactooth {

/// Of a length computed in single precision by a few operations: what rounding has made of it at most.
inline constexpr double kFewRoundings = 1e-6;

/// Where a tool may move before it meets what was not near: its origin (the tip) is shifted to within `around` of the
/// segment from where it was to `along` further on, and it is turned by `turn`. A turn moves its point p by
/// turn * |p| at most.
struct ContactMargin {
    Vec3 along = Vec3::Zero();  ///< mm, in the tooth's frame
    double around = 0;          ///< mm
    double turn = 0;            ///< chord: twice the sine of half the angle

    /// Distance of a shift from the segment, mm.
    [[nodiscard]] double deviation(const Vec3& shift) const {
        const double squared = along.squaredNorm();
        const double share = squared > 0 ? std::clamp(shift.dot(along) / squared, 0.0, 1.0) : 0;
        return (shift - share * along).norm();
    }
    /// The longest shift within it, mm.
    [[nodiscard]] double length() const { return along.norm() + around; }
};

}  // namespace tactooth
