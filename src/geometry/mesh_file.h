// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/expected.h"
#include "geometry/triangle_mesh.h"

namespace tactooth {

/// Reads a surface from a file of any format that the program knows: STL (binary and ASCII, see `readStl`), PLY (see
/// `parsePly`) and Wavefront OBJ (see `parseObj`). The content decides, but for OBJ, which has no mark of its own: what
/// is neither STL nor PLY and is named *.obj is read as OBJ. For another mesh format the error names it and says what
/// to do.
[[nodiscard]] Expected<TriangleMesh> loadMesh(const std::filesystem::path& path);

}  // namespace tactooth
