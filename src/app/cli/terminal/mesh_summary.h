// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "geometry/mesh/mesh_report.h"

namespace tactooth {

/// "325312 triangles, closed, 1 shell".
[[nodiscard]] std::string meshSummary(const MeshReport& report);

/// Says on stdout what a command has made of a surface: numbers before and after, and how far the two are apart, mm.
void printChange(const std::filesystem::path& in, const TriangleMesh& before, const std::filesystem::path& out,
                 const TriangleMesh& after, double deviation);

}  // namespace tactooth
