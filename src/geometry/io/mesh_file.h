// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "geometry/io/read_mesh.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Reads a surface from a file of any supported format: STL (binary and ASCII, see `readStl`), PLY (see `parsePly`) and
/// Wavefront OBJ (see `parseObj`). The content decides, except for OBJ, which has no signature: a file named *.obj that
/// is neither STL nor PLY is read as OBJ. For another mesh format the error names it and the remedy. A surface too far
/// from the origin for single precision comes with the offset that was subtracted. Import notes report the offset and
/// skipped lines.
[[nodiscard]] Expected<ReadMesh> readMesh(const std::filesystem::path& path);

/// The surface in the file's frame, for all measurements in that frame. Fails also if the surface is too far from the
/// origin for single precision: it is never shifted silently. Adds the import notes to `importNotes`, if given.
[[nodiscard]] Expected<TriangleMesh> loadMesh(const std::filesystem::path& path,
                                              std::vector<ImportNote>* importNotes = nullptr);

}  // namespace tactooth
