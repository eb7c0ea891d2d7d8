// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "geometry/util/vec.h"

namespace tactooth {

/// A shift and a rotation of a rigid body as one vector: the shift (mm), then the rotation vector times a length (mm).
using Vec6 = Eigen::Matrix<double, 6, 1>;

/// The half-space of all x with normal * x >= offset. `normal` has any length but zero.
struct HalfSpace6 {
    Vec6 normal;
    double offset;
};

/// Solution of solveQp6.
struct Qp6Result {
    bool feasible = false;               ///< false: no common point was found
    Vec6 point = Vec6::Zero();           ///< the common point nearest to the target
    int activeCount = 0;                 ///< half-spaces in the active set, 0..6
    std::array<int, 6> active{};         ///< their numbers
    std::array<double, 6> multiplier{};  ///< point - target = sum of multiplier * normal over the active ones, >= 0
};

/// The point of the intersection of `halfSpaces` (a few dozen at most) nearest to `target`. A half-space counts as
/// violated only by more than `tolerance`, in the unit of its offset.
[[nodiscard]] Qp6Result solveQp6(std::span<const HalfSpace6> halfSpaces, const Vec6& target, double tolerance);

}  // namespace tactooth
