// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// `mesh` with each vertex that is within `tolerance` mm of an earlier one moved onto that one, in the order of their
/// numbers; the first of a group stays. Triangles stay in their order, also those without an area. `tolerance` is
/// finite and positive. `moved`, if given, is the number of vertices that were moved. `mayMove`, if not empty, has one
/// entry for each vertex: only marked vertices are moved, and only onto a marked one.
[[nodiscard]] TriangleMesh weldedWithin(const TriangleMesh& mesh, double tolerance, std::size_t* moved = nullptr,
                                        std::span<const std::uint8_t> mayMove = {});

}  // namespace tactooth
