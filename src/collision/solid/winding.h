// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "collision/bvh/surface.h"

namespace tactooth {

/// A point of a triangle: the weights of its corners, at or above 0, with the sum 1.
using Barycentric = Vec3;
inline const Barycentric kCentroid = Barycentric::Constant(1.0 / 3);

/// The winding number of the closed surface `part` just in front of a triangle, on the side of its normal: in how many
/// bodies this point lies. 0 if the triangle is a border between inside and outside. Not 0 if the triangle is inside a
/// body, or faces the wrong side. For a triangle without area: 0.
[[nodiscard]] int windingInFront(const SurfacePart& part, std::uint32_t triangle, const Barycentric& place = kCentroid);

/// Distance from a point of a triangle to the next triangle, mm, along the normal (`inFront`) or against it. Infinite
/// if there is none.
[[nodiscard]] double clearanceFrom(const SurfacePart& part, std::uint32_t triangle, bool inFront,
                                   const Barycentric& place = kCentroid);

}  // namespace tactooth
