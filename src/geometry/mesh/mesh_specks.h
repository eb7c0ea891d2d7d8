// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Pieces smaller than this part of the largest body are specks, in length.
inline constexpr double kSpeck = 0.05;

/// What is no speck makes at least this part of a surface's area; else its pieces, or triangles that hang together with
/// nothing, are no body with specks, and stay.
inline constexpr double kLeastBody = 0.98;

/// Drops triangles without an area that hang together with nothing, and specks: pieces whose box has a diagonal, or
/// whose area is that of a piece, of less than `kSpeck` of the largest body's. The largest body is the one with the
/// largest area, so that nothing far away or thin changes what is small. Pieces within its box stay: they may be walls
/// of hollows. Vertices stay, also those that no triangle uses any more. Returns how many pieces were dropped.
std::size_t dropSpecks(TriangleMesh& mesh);

/// The box of what `dropSpecks` leaves.
[[nodiscard]] Box3 boxExcludingSpecks(TriangleMesh mesh);

}  // namespace tactooth
