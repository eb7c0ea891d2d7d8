// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "support/mesh_checks.h"

#include <cstring>
#include <map>
#include <utility>

#include "geometry/mesh/vertex_welder.h"
#include "geometry/util/disjoint_sets.h"

namespace tactooth::test {
namespace {

/// The mesh with equal points united.
TriangleMesh welded(const TriangleMesh& mesh) {
    std::vector<Vec3f> corners;
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) corners.push_back(mesh.vertices[vertex]);
    }
    return weld(corners);
}

double sixfoldVolume(const TriangleMesh& mesh, std::size_t t) {
    return mesh.corner(t, 0).dot(mesh.corner(t, 1).cross(mesh.corner(t, 2)));
}

}  // namespace

std::optional<std::size_t> firstInvalidTriangle(const TriangleMesh& mesh) {
    const auto isValid = [&](std::uint32_t vertex) {
        return vertex < mesh.vertices.size() && mesh.vertices[vertex].allFinite();
    };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (const std::uint32_t vertex : mesh.triangles[t]) {
            if (!isValid(vertex)) return t;
        }
    }
    return std::nullopt;
}

int unpairedEdges(const TriangleMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const Triangle& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) ++uses[{t[i], t[(i + 1) % 3]}];
    }
    int unpaired = 0;
    for (const auto& [edge, count] : uses) unpaired += count != 1 || !uses.contains({edge.second, edge.first});
    return unpaired;
}

int openEdges(const TriangleMesh& mesh) { return unpairedEdges(welded(mesh)); }

double volumeOf(const TriangleMesh& mesh) {
    double sixfold = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) sixfold += sixfoldVolume(mesh, t);
    return sixfold / 6;
}

std::vector<double> pieceVolumes(const TriangleMesh& mesh) {
    const TriangleMesh joined = welded(mesh);
    DisjointSets sets(joined.vertices.size());
    for (const Triangle& triangle : joined.triangles) {
        sets.join(triangle[0], triangle[1]);
        sets.join(triangle[1], triangle[2]);
    }
    std::map<std::uint32_t, double> volumes;
    for (std::size_t t = 0; t < joined.triangles.size(); ++t) {
        volumes[sets.find(joined.triangles[t][0])] += sixfoldVolume(joined, t) / 6;
    }
    std::vector<double> result;
    for (const auto& [first, volume] : volumes) result.push_back(volume);
    return result;
}

bool areBitEqual(const TriangleMesh& a, const TriangleMesh& b) {
    return a.triangles == b.triangles && a.vertices.size() == b.vertices.size() &&
           std::memcmp(a.vertices.data(), b.vertices.data(), a.vertices.size() * sizeof(Vec3f)) == 0;
}

}  // namespace tactooth::test
