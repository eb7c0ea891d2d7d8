// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "collision/bvh/surface.h"
#include "collision/neighbours/tool_shape.h"
#include "geometry/io/import_note.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// A tooth that is only felt, from its STL file: no layers, tags all zero. Also works with an open surface; then only
/// the triangles are felt, and nothing is "inside". Fails with one sentence, also if parts of the surface reach into
/// each other (`examineSolid`). Adds what there is to say on the file, and what was mended, to `importNotes`, if given.
[[nodiscard]] Expected<std::shared_ptr<const Surface>> loadSurface(const std::filesystem::path& path,
                                                                   std::vector<ImportNote>* importNotes = nullptr);

/// A tool from its STL file, in its own frame (tip at the origin, +z along the shaft).
[[nodiscard]] Expected<std::shared_ptr<const ToolShape>> loadTool(const std::filesystem::path& path,
                                                                  std::vector<ImportNote>* importNotes = nullptr);

}  // namespace tactooth
