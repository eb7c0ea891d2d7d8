// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/assert.h"

namespace tactooth {

/// The use of an edge by one triangle: a side of that triangle.
struct EdgeUse {
    std::uint32_t other;   ///< the edge's larger vertex number
    std::uint32_t corner;  ///< where the side begins: 3 * triangle + number of the corner
    bool upward;           ///< the side runs from the smaller vertex number to the larger
};

/// Whether two corners of the triangle are the same vertex.
[[nodiscard]] inline bool isDegenerate(const Triangle& triangle) {
    return triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
}

/// Edges that prevent a surface from having an inside. Triangles with two equal corners do not count.
struct EdgeBalance {
    std::size_t odd = 0;      ///< edges with one, three, five ... triangles: the surface is open there
    std::size_t against = 0;  ///< other edges that are not run through as often in one direction as in the other

    /// Every edge is run through as often in one direction as in the other: the definition of a closed surface. Edges
    /// of four or more triangles, where parts of the surface touch, are allowed.
    [[nodiscard]] bool closed() const { return odd == 0 && against == 0; }
};

/// Takes time in proportion to the size of `mesh`.
[[nodiscard]] EdgeBalance edgeBalance(const TriangleMesh& mesh);

/// All sides of the triangles that are not degenerate, sorted so that the sides of one edge are adjacent.
class MeshEdges {
public:
    /// `mesh` has less than 2^32 / 3 triangles.
    explicit MeshEdges(const TriangleMesh& mesh);

    /// Calls `visit(uses)` for each edge, `uses` (a span of EdgeUse) in the order of the triangles.
    template <class Visit>
    void forEachEdge(Visit&& visit) const {
        for (std::size_t vertex = 0; vertex + 1 < firstUse_.size(); ++vertex) {
            const std::size_t end = firstUse_[vertex + 1];
            for (std::size_t first = firstUse_[vertex], last; first < end; first = last) {
                TACTOOTH_ASSERT(first < uses_.size() && end <= uses_.size());
                for (last = first + 1; last < end && uses_[last].other == uses_[first].other;) ++last;
                visit(std::span(uses_).subspan(first, last - first));
            }
        }
    }

private:
    std::vector<std::size_t> firstUse_;  ///< by smaller vertex number, into uses_
    std::vector<EdgeUse> uses_;
};

}  // namespace tactooth
