// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "support/mesh_checks.h"

#include <cstring>
#include <map>
#include <utility>

namespace tactooth::test {

int unpairedEdges(const TriangleMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const Triangle& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) ++uses[{t[i], t[(i + 1) % 3]}];
    }
    int unpaired = 0;
    for (const auto& [edge, count] : uses) unpaired += count != 1 || !uses.contains({edge.second, edge.first});
    return unpaired;
}

double volumeOf(const TriangleMesh& mesh) {
    double sixfold = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        sixfold += mesh.corner(t, 0).dot(mesh.corner(t, 1).cross(mesh.corner(t, 2)));
    }
    return sixfold / 6;
}

bool areBitEqual(const TriangleMesh& a, const TriangleMesh& b) {
    return a.triangles == b.triangles && a.vertices.size() == b.vertices.size() &&
           std::memcmp(a.vertices.data(), b.vertices.data(), a.vertices.size() * sizeof(Vec3f)) == 0;
}

}  // namespace tactooth::test
