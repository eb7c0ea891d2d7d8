// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "geometry/expected.h"
#include "geometry/triangle_mesh.h"

namespace tactooth {

/// Reads the surface of a Wavefront OBJ file from memory; `name` stands for the file in error messages. Positions (`v`)
/// and faces (`f`, also with texture and normal numbers, also counted from the end) are read, polygons are split into
/// triangles from their first corner, vertices at equal positions become one; all other lines are passed over. Memory
/// use is bounded by a small multiple of `bytes.size()`.
///
/// Fails with one sentence, which names the line, on a face that names a vertex the file has not given, on numbers that
/// are none or not finite, and on a file without faces.
[[nodiscard]] Expected<TriangleMesh> parseObj(std::span<const std::byte> bytes, std::string_view name);

}  // namespace tactooth
