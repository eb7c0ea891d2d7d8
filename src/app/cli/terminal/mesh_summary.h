// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "geometry/mesh/mesh_report.h"

namespace tactooth {

/// Example: "325312 triangles, closed, 1 shell".
[[nodiscard]] std::string meshSummary(const MeshReport& report);

/// Prints the change of a surface by a command: the numbers before and after, and the distance between the two, mm.
void printChange(const std::filesystem::path& in, const TriangleMesh& before, const std::filesystem::path& out,
                 const TriangleMesh& after, double deviation);

}  // namespace tactooth
