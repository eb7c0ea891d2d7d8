// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/expected.h"

namespace tactooth {

enum class StlFormat { Binary, Ascii };

/// Writes `mesh` in mm, triangles in their order, every coordinate so that reading it gives the same float, bit for
/// bit, in both formats. Normals are computed (zero for a triangle without area). The file appears complete or not at
/// all (see AtomicFile).
[[nodiscard]] Expected<void> writeStl(const TriangleMesh& mesh, const std::filesystem::path& path,
                                      StlFormat format = StlFormat::Binary);

/// The content that `writeStl` writes. `mesh` has less than 2^32 triangles.
[[nodiscard]] std::vector<std::byte> stlBytes(const TriangleMesh& mesh, StlFormat format = StlFormat::Binary);

}  // namespace tactooth
