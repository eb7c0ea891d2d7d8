// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/assert.h"

namespace tactooth {

/// Adds to `mesh` the triangles of `from` for which `predicate(number)` is true, and the vertices that they use, in the
/// order of their first use. Calls the predicate once for each triangle, in order, and `takes(number)` for each vertex
/// that it adds.
template <class Chooses, class Takes>
void appendSubset(TriangleMesh& mesh, const TriangleMesh& from, const Chooses& predicate, const Takes& takes) {
    constexpr std::uint32_t kUnused = UINT32_MAX;
    std::vector<std::uint32_t> numbers(from.vertices.size(), kUnused);
    for (std::uint32_t t = 0; t < from.triangles.size(); ++t) {
        if (!predicate(t)) continue;
        Triangle triangle = from.triangles[t];
        for (std::uint32_t& vertex : triangle) {
            TACTOOTH_ASSERT(vertex < numbers.size());
            std::uint32_t& number = numbers[vertex];
            if (number == kUnused) {
                number = static_cast<std::uint32_t>(mesh.vertices.size());
                mesh.vertices.push_back(from.vertices[vertex]);
                takes(vertex);
            }
            vertex = number;
        }
        mesh.triangles.push_back(triangle);
    }
}
template <class Chooses>
void appendSubset(TriangleMesh& mesh, const TriangleMesh& from, const Chooses& predicate) {
    appendSubset(mesh, from, predicate, [](std::uint32_t) {});
}

}  // namespace tactooth
