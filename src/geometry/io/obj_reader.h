// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "geometry/io/read_mesh.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Reads the surface of a Wavefront OBJ file from memory; `name` stands for the file in messages. Positions (`v`) and
/// faces (`f`, also with texture and normal numbers, also counted from the end) are read; polygons are split within
/// their outline (PolygonTriangulator); vertices at equal positions become one. Lines end in LF, CR LF or CR, and go on
/// in the next after a backslash. Normals, texture, groups, materials, points and lines are passed over; lines that are
/// not understood are counted in a remark. Coordinates far from zero: see ReadMesh::offset. Memory use is bounded by a
/// small multiple of `bytes.size()`.
///
/// Fails with one sentence, which names the line, on a face that names a vertex the file has not given or whose outline
/// crosses itself, on numbers that are none or not finite, and on a file without faces.
[[nodiscard]] Expected<ReadMesh> parseObj(std::span<const std::byte> bytes, std::string_view name);

}  // namespace tactooth
