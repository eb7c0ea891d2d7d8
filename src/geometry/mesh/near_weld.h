// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// `mesh` with vertices that lie within `tolerance` mm of an earlier one put onto it, in the order of their numbers;
/// the first of a group stays where it is. Triangles stay in their order, also those that have lost their area.
/// `moved`, if given, is how many vertices were put onto another. `mayMove`, if not empty: only vertices that it marks
/// are put onto another, and only onto a marked one.
[[nodiscard]] TriangleMesh weldedWithin(const TriangleMesh& mesh, double tolerance, std::size_t* moved = nullptr,
                                        std::span<const std::uint8_t> mayMove = {});

}  // namespace tactooth
