// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "collision/bvh/surface.h"

namespace tactooth {

/// A place in a triangle: how much of each corner, at or above 0, with the sum 1.
using Barycentric = Vec3;
inline const Barycentric kCentroid = Barycentric::Constant(1.0 / 3);

/// How many bodies hold the space just in front of a triangle, on the side to which its normal points: the winding
/// number there of the closed surface `part`. 0 where the triangle is a border between inside and outside; another
/// number where it lies within a body, or looks the wrong way. Of a triangle without area: 0.
[[nodiscard]] int windingInFront(const SurfacePart& part, std::uint32_t triangle, const Barycentric& place = kCentroid);

/// How far a point may go from a place in a triangle, square to it, until it comes to another one, mm: in the direction
/// of the normal or against it. Infinite if there is none.
[[nodiscard]] double clearanceFrom(const SurfacePart& part, std::uint32_t triangle, bool inFront,
                                   const Barycentric& place = kCentroid);

}  // namespace tactooth
