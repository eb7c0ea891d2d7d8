// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "geometry/io/read_mesh.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Does what `readMesh` does, from memory; `path` gives the name for messages and the extension.
[[nodiscard]] Expected<ReadMesh> parseReadMesh(std::span<const std::byte> bytes, const std::filesystem::path& path);

/// Does what `loadMesh` does, from memory.
[[nodiscard]] Expected<TriangleMesh> parseMesh(std::span<const std::byte> bytes, const std::filesystem::path& path,
                                               std::vector<ImportNote>* importNotes = nullptr);

}  // namespace tactooth
