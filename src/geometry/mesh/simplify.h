// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A closed surface with about `triangles` triangles: large ones where it is flat, small ones where it is curved. Its
/// vertices are a subset of the old ones. It stays closed, oriented and of the same genus; where this prevents further
/// collapses, more triangles remain.
[[nodiscard]] TriangleMesh simplified(const TriangleMesh& closed, std::size_t triangles);

}  // namespace tactooth
