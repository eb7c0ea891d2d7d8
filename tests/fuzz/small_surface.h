// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/io/stl_writer.h"

namespace tactooth::test {

/// A tetrahedron as an STL file, so that a description has a surface to name.
[[nodiscard]] inline std::vector<std::byte> smallSurface() {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    return stlBytes(mesh);
}

}  // namespace tactooth::test
