// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// How far two surfaces are apart where they are farthest apart, mm: the greatest distance of a corner, an edge's
/// middle or a triangle's middle of either from the other (the Hausdorff distance, as far as those points see it).
[[nodiscard]] double hausdorffDistance(const TriangleMesh& one, const TriangleMesh& other);

/// The greatest distance of a vertex of `of` from the surface `to`, mm.
[[nodiscard]] double maxVertexDistance(const TriangleMesh& of, const TriangleMesh& to);

}  // namespace tactooth
