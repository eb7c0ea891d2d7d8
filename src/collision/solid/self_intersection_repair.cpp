// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/self_intersection_repair.h"

#include "collision/solid/self_intersection.h"

namespace tactooth {

bool repairSelfIntersections(TriangleMesh& mesh, const std::vector<Vec3f>& restPositions) {
    constexpr int kIterations = 8;
    for (int round = 0; round < kIterations; ++round) {
        const auto crossing = selfIntersectingTriangles(SurfacePart(mesh));
        if (!crossing) return false;
        if (crossing->empty()) return true;
        std::vector<std::uint8_t> goes(mesh.vertices.size(), 0);
        for (const std::uint32_t t : *crossing) {
            for (const std::uint32_t vertex : mesh.triangles[t]) goes[vertex] = 1;
        }
        for (int ring = 0; ring < round; ++ring) {
            std::vector<std::uint8_t> wider = goes;
            for (const Triangle& t : mesh.triangles) {
                if ((goes[t[0]] | goes[t[1]] | goes[t[2]]) == 0) continue;
                for (const std::uint32_t vertex : t) wider[vertex] = 1;
            }
            goes.swap(wider);
        }
        for (std::size_t i = 0; i < goes.size(); ++i) {
            if (goes[i] != 0) mesh.vertices[i] = restPositions[i];
        }
    }
    const auto left = selfIntersectingTriangles(SurfacePart(mesh));
    return left && left->empty();
}

}  // namespace tactooth
