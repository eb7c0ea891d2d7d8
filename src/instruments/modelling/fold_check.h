// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Whether two triangles of a closed surface lie back to back: where a body is thinner than the cells that it was
/// meshed with, its two sides may have crossed. `sharpest`: cosine between the normals of two triangles at the sharpest
/// edge that the body has; no edge of a tooth is below -0.85.
[[nodiscard]] bool hasFolds(const TriangleMesh& mesh, double sharpest = -0.9);

}  // namespace tactooth
