// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Hausdorff distance of two surfaces, sampled at the corners, edge midpoints and centroids of both, mm.
[[nodiscard]] double hausdorffDistance(const TriangleMesh& one, const TriangleMesh& other);

/// The greatest distance of a vertex of `of` from the surface `to`, mm.
[[nodiscard]] double maxVertexDistance(const TriangleMesh& of, const TriangleMesh& to);

}  // namespace tactooth
