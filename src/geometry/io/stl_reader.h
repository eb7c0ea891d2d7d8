// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Reads a binary or ASCII STL file; its content decides which, never its first word alone.
///
/// Corners at equal positions become one vertex (see VertexWelder). Every triangle of the file stays, in its order
/// (those of several solids one after the other), also if it is degenerate; `reportOn` counts these. Stored normals and
/// attribute bytes are ignored: the order of the corners gives the outside. Numbers have '.' as decimal point whatever
/// the locale, and are rounded to single precision without an offset (`readMesh` adds one where it is needed).
///
/// Fails with one sentence on everything that is not a complete, finite, non-empty STL surface.
[[nodiscard]] Expected<TriangleMesh> readStl(const std::filesystem::path& path);

/// The same from memory; `name` is the name of the file in messages. Memory use is bounded by a small multiple of
/// `bytes.size()`, whatever the bytes claim.
[[nodiscard]] Expected<TriangleMesh> parseStl(std::span<const std::byte> bytes, std::string_view name);

}  // namespace tactooth
