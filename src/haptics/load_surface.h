// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "collision/surface.h"
#include "collision/tool_shape.h"
#include "geometry/expected.h"

namespace tactooth {

/// A tooth that is only felt, from its STL file: no layers, tags all zero. Also works with an open surface; then only
/// the triangles are felt, and nothing is "inside".
[[nodiscard]] Expected<std::shared_ptr<const Surface>> loadSurface(const std::filesystem::path& path);

/// A tool from its STL file, in its own frame (tip at the origin, +z along the shaft).
[[nodiscard]] Expected<std::shared_ptr<const ToolShape>> loadTool(const std::filesystem::path& path);

}  // namespace tactooth
