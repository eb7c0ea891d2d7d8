// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/terminal/mesh_summary.h"
#include "app/cli/terminal/output.h"

#include <fmt/core.h>

#include "geometry/files/file_bytes.h"

namespace tactooth {

std::string meshSummary(const MeshReport& report) {
    const std::string closed = report.closed() ? "closed"
                                               : fmt::format("not closed ({} open and {} overused edges)",
                                                             report.boundaryEdges, report.nonManifoldEdges);
    return fmt::format("{} triangles, {}, {} shell{}", report.triangles, closed, report.shells.size(),
                       report.shells.size() == 1 ? "" : "s");
}

void printChange(const std::filesystem::path& in, const TriangleMesh& before, const std::filesystem::path& out,
                 const TriangleMesh& after, double deviation) {
    constexpr double kMicrons = 1e3;  // per mm
    print("{}: {}\n", displayName(in), meshSummary(reportOn(before)));
    print("{}: {}\n", displayName(out), meshSummary(reportOn(after)));
    print("greatest deviation {:.3g} um\n", kMicrons * deviation);
}

}  // namespace tactooth
