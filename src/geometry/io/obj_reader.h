// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "geometry/io/read_mesh.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Reads the surface of a Wavefront OBJ file from memory; `name` is the name of the file in messages. It reads
/// positions (`v`) and faces (`f`, also with texture and normal numbers, also counted from the end). Polygons are split
/// within their outline (PolygonTriangulator), and vertices at equal positions become one. Lines end in LF, CR LF or
/// CR, and continue after a backslash. Normals, texture, groups, materials, points and lines are skipped; an import
/// note counts the lines that are not understood. For coordinates far from the origin see ReadMesh::offset. Memory use
/// is bounded by a small multiple of `bytes.size()`.
///
/// Fails with one sentence that names the line: on a face with an unknown vertex or with an outline that crosses
/// itself, on bad or infinite numbers, and on a file without faces.
[[nodiscard]] Expected<ReadMesh> parseObj(std::span<const std::byte> bytes, std::string_view name);

}  // namespace tactooth
