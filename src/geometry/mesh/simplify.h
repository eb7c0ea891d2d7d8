// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A closed surface with about `triangles` triangles instead of more: large ones where it is flat, small ones where it
/// bends. Its vertices are some of the old ones. It stays closed, oriented and of the same genus; where that forbids to
/// go on, more triangles remain.
[[nodiscard]] TriangleMesh simplified(const TriangleMesh& closed, std::size_t triangles);

}  // namespace tactooth
