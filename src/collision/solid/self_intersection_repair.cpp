// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/self_intersection_repair.h"

#include "collision/solid/self_intersection.h"
#include "geometry/util/assert.h"

// Own method, without a published source: vertices of crossing triangles go back to their rest positions, in growing
// rings.

namespace tactooth {

bool repairSelfIntersections(TriangleMesh& mesh, const std::vector<Vec3f>& restPositions) {
    TACTOOTH_ASSERT(restPositions.size() == mesh.vertices.size());
    constexpr int kIterations = 8;
    for (int iteration = 0; iteration < kIterations; ++iteration) {
        const auto crossing = selfIntersectingTriangles(SurfacePart(mesh));
        if (!crossing) return false;
        if (crossing->empty()) return true;
        std::vector<std::uint8_t> isReset(mesh.vertices.size(), 0);
        for (const std::uint32_t t : *crossing) {
            for (const std::uint32_t vertex : mesh.triangles[t]) isReset[vertex] = 1;
        }
        for (int ring = 0; ring < iteration; ++ring) {
            std::vector<std::uint8_t> wider = isReset;
            for (const Triangle& t : mesh.triangles) {
                if ((isReset[t[0]] | isReset[t[1]] | isReset[t[2]]) == 0) continue;
                for (const std::uint32_t vertex : t) wider[vertex] = 1;
            }
            isReset.swap(wider);
        }
        for (std::size_t i = 0; i < isReset.size(); ++i) {
            if (isReset[i] != 0) mesh.vertices[i] = restPositions[i];
        }
    }
    const auto left = selfIntersectingTriangles(SurfacePart(mesh));
    return left && left->empty();
}

}  // namespace tactooth
