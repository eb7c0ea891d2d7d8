// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <string_view>

#include "geometry/mesh/mesh_report.h"

namespace tactooth {
namespace {

/// "1 edge has" or "12 edges have", and the rest of the sentence.
std::string counted(std::size_t count, std::string_view one, std::string_view many, std::string_view rest) {
    return std::to_string(count) + " " + std::string(count == 1 ? one : many) + " " + std::string(rest);
}

}  // namespace

std::vector<std::string> findings(const MeshReport& report) {
    std::vector<std::string> result;
    const auto add = [&](std::size_t count, std::string_view one, std::string_view many, std::string_view rest) {
        if (count > 0) result.push_back(counted(count, one, many, rest));
    };
    add(report.boundaryEdges, "edge is", "edges are", "open: the surface has a hole and no inside.");
    add(report.oddEdges, "edge has", "edges have",
        "three, five or more triangles: a wall inside, or a hole at a seam.");
    add(report.nonManifoldEdges - report.oddEdges, "edge has", "edges have",
        "four or more triangles: parts of the surface touch there.");
    add(report.inconsistentEdges, "edge lies", "edges lie",
        "between triangles that disagree on which side is outside.");
    if (report.insideOut()) result.emplace_back("The surface is inside out: its triangles turn clockwise.");
    add(report.pinchedVertices, "point is", "points are", "the only contact between parts of the surface.");
    add(report.degenerateTriangles, "triangle has", "triangles have", "two equal corners.");
    add(report.flatTriangles, "triangle has", "triangles have", "no area: the three corners lie in a line.");
    add(report.duplicateTriangles, "triangle is", "triangles are", "stored more than once.");
    return result;
}

}  // namespace tactooth
