// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "geometry/io/read_mesh.h"
#include "geometry/util/expected.h"

// Shared by the STL reader and writer. Format: 3D Systems, "StereoLithography Interface Specification" (1989).
namespace tactooth::stl {

inline constexpr std::size_t kHeaderBytes = 80;
inline constexpr std::size_t kCountBytes = 4;    ///< triangle count, little-endian
inline constexpr std::size_t kRecordBytes = 50;  ///< normal and three corners (12 floats), 2 attribute bytes
inline constexpr std::size_t kVectorBytes = 12;  ///< three floats
inline constexpr std::size_t kFirstRecord = kHeaderBytes + kCountBytes;

/// Parses binary STL whose count matches its size.
[[nodiscard]] Expected<TriangleMesh> parseBinary(std::span<const std::byte> bytes, const std::string& name);

/// Parses ASCII STL: one or more `solid ... endsolid`. Coordinates far from zero: see ReadMesh::offset.
[[nodiscard]] Expected<ReadMesh> parseAscii(std::string_view text, const std::string& name);

/// The same, rounded to single precision without an offset.
[[nodiscard]] Expected<ReadMesh> parseAsciiInPlace(std::string_view text, const std::string& name);

/// The error for bytes that are neither of the two: what they seem to be instead, or what is missing.
[[nodiscard]] Error explainRefusal(std::span<const std::byte> bytes, const std::string& name);

}  // namespace tactooth::stl
