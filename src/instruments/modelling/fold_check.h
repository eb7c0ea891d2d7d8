// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Whether two adjacent triangles of a closed surface are folded onto each other: where a body is thinner than its mesh
/// cells, its two sides may have crossed. `sharpest`: cosine between the normals of two triangles at the sharpest edge
/// of the body; no edge of a tooth is below -0.85.
[[nodiscard]] bool hasFolds(const TriangleMesh& mesh, double sharpest = -0.9);

}  // namespace tactooth
