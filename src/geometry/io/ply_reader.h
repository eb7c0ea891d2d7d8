// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "geometry/io/read_mesh.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Reads the surface of a PLY file, ASCII or binary of either byte order, from memory; `name` is the name of the file
/// in messages. It reads x, y, z of the element `vertex`, the corners of the element `face` (`vertex_indices` or
/// `vertex_index`) and triangle strips (`tristrips`, in which -1 begins a new strip), and skips all else. Polygons are
/// split within their outline (PolygonTriangulator), and vertices at equal positions become one. For coordinates far
/// from the origin see ReadMesh::offset. Memory use is bounded by a small multiple of `bytes.size()`, whatever the
/// header claims.
///
/// Fails with one sentence on a file that is cut short, has no vertices or faces, names a missing vertex, or has a face
/// whose outline crosses itself.
[[nodiscard]] Expected<ReadMesh> parsePly(std::span<const std::byte> bytes, std::string_view name);

}  // namespace tactooth
