// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "geometry/util/assert.h"
#include "geometry/util/vec.h"

namespace tactooth {

/// The greatest relative error of a length computed in single precision by a few operations.
inline constexpr double kFewRoundings = 1e-6;

/// The motion of a tool for which a neighbour list is complete (the skin of a Verlet list). The tool's origin (its tip)
/// stays within `around` of a segment: from its position when the list was built, by the vector `along`. The tool
/// rotates by at most `turn`, which moves its point p by at most turn * |p|.
struct ContactMargin {
    Vec3 along = Vec3::Zero();  ///< mm, in the tooth's frame
    double around = 0;          ///< mm
    double turn = 0;            ///< chord: twice the sine of half the angle

    /// Distance of a shift from the segment, mm.
    [[nodiscard]] double deviation(const Vec3& shift) const {
        TACTOOTH_ASSERT(shift.allFinite());
        const double squared = along.squaredNorm();
        const double share = squared > 0 ? std::clamp(shift.dot(along) / squared, 0.0, 1.0) : 0;
        return (shift - share * along).norm();
    }
    /// The longest shift that it covers, mm.
    [[nodiscard]] double length() const { return along.norm() + around; }
};

}  // namespace tactooth
