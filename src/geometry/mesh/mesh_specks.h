// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Components smaller than this fraction of the largest body, in length, are specks.
inline constexpr double kSpeck = 0.05;

/// The components that are not specks must have at least this fraction of the surface's area. Else the surface is no
/// body with a few specks beside it, and all components stay.
inline constexpr double kLeastBody = 0.98;

/// Drops isolated triangles without an area, and specks: components whose bounding box has a diagonal of less than
/// `kSpeck` of the largest body's, or whose area is that of such a component. The largest body is the one with the
/// largest area, so that a component that is far away or thin does not change what is small. Components within its box
/// stay: they may be walls of voids. Vertices stay, also unused ones. Returns the number of dropped components.
std::size_t dropSpecks(TriangleMesh& mesh);

/// The bounding box of what `dropSpecks` leaves.
[[nodiscard]] Box3 boxExcludingSpecks(TriangleMesh mesh);

}  // namespace tactooth
