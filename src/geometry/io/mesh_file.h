// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "geometry/io/read_mesh.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Reads a surface from a file of any format that the program knows: STL (binary and ASCII, see `readStl`), PLY (see
/// `parsePly`) and Wavefront OBJ (see `parseObj`). The content decides, but for OBJ, which has no mark of its own: what
/// is neither STL nor PLY and is named *.obj is read as OBJ. For another mesh format the error names it and says what
/// to do. A surface too far from zero for single precision comes with the offset that was subtracted; remarks tell of
/// it and of lines that were passed over.
[[nodiscard]] Expected<ReadMesh> readMesh(const std::filesystem::path& path);

/// The surface in the file's frame, for all that measures there. Fails also if the surface lies too far from zero for
/// single precision: it is never shifted in silence. Adds the remarks to `importNotes`, if that is given.
[[nodiscard]] Expected<TriangleMesh> loadMesh(const std::filesystem::path& path,
                                              std::vector<ImportNote>* importNotes = nullptr);

}  // namespace tactooth
