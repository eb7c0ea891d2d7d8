// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "geometry/util/vec.h"

namespace tactooth {

/// The half-space of all x (mm) with normal * x >= offset.
struct HalfSpace {
    Vec3 normal;    ///< unit, into the half-space
    double offset;  ///< mm
};

/// Solution of solveQp3.
struct Qp3Result {
    bool feasible = false;               ///< false: the half-spaces have no common point
    Vec3 point = Vec3::Zero();           ///< the common point nearest to the target
    int activeCount = 0;                 ///< half-spaces in the active set, 0..3
    std::array<int, 3> active{};         ///< their numbers
    std::array<double, 3> multiplier{};  ///< point - target = sum of multiplier * normal over the active ones, >= 0
};

/// The point of the intersection of `halfSpaces` (a few dozen at most) nearest to `target`. A half-space counts as
/// violated only by more than `tolerance` (a length).
[[nodiscard]] Qp3Result solveQp3(std::span<const HalfSpace> halfSpaces, const Vec3& target, double tolerance);

}  // namespace tactooth
