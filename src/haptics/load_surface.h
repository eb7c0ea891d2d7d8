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

/// Loads a tooth for touch only from its STL file: no layers, all tags zero. Also works with an open surface; then only
/// the triangles are touched, and nothing is "inside". Fails with one sentence, also if parts of the surface overlap
/// (`examineSolid`). Adds notes on the file and its repairs to `importNotes`, if given.
[[nodiscard]] Expected<std::shared_ptr<const Surface>> loadSurface(const std::filesystem::path& path,
                                                                   std::vector<ImportNote>* importNotes = nullptr);

/// Loads a tool from its STL file, in its own frame (tip at the origin, +z along the shaft).
[[nodiscard]] Expected<std::shared_ptr<const ToolShape>> loadTool(const std::filesystem::path& path,
                                                                  std::vector<ImportNote>* importNotes = nullptr);

}  // namespace tactooth
