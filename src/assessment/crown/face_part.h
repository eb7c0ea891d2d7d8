// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// The part of the faces where a value is above 0. `values`: one for each vertex; linear over each triangle, so that
/// the part ends in a line that does not follow the triangles.
[[nodiscard]] TriangleMesh partAbove(const TriangleMesh& mesh, std::span<const double> values);

}  // namespace tactooth
