// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/untangle.h"

#include "collision/solid/crossing_search.h"

namespace tactooth {

bool untangle(TriangleMesh& mesh, const std::vector<Vec3f>& home) {
    constexpr int kRounds = 8;
    for (int round = 0; round < kRounds; ++round) {
        const auto crossing = crossingTriangles(SurfacePart(mesh));
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
            if (goes[i] != 0) mesh.vertices[i] = home[i];
        }
    }
    const auto left = crossingTriangles(SurfacePart(mesh));
    return left && left->empty();
}

}  // namespace tactooth
