// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/mesh_edges.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "support/shapes.h"

namespace tactooth {
namespace {

/// Oracle: every edge in a map.
EdgeBalance balanceByMap(const TriangleMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> edges;  // uses, and upward less downward
    for (const Triangle& t : mesh.triangles) {
        if (isDegenerate(t)) continue;
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            auto& [uses, balance] = edges[std::minmax(a, b)];
            ++uses;
            balance += a < b ? 1 : -1;
        }
    }
    EdgeBalance result;
    for (const auto& [edge, use] : edges) {
        result.odd += use.first % 2 != 0;
        result.against += use.first % 2 == 0 && use.second != 0;
    }
    return result;
}

TEST(EdgeBalance, IsThatOfEachEdgeCountedByItself) {
    std::mt19937 random(31);
    int closed = 0, open = 0;
    for (int round = 0; round < 300; ++round) {
        TriangleMesh mesh;
        const std::uint32_t vertices = 4 + random() % 8;
        mesh.vertices.resize(vertices, Vec3f::Zero());
        for (std::uint32_t t = 0; t < 1 + random() % 40; ++t) {
            const Triangle one = {std::uint32_t(random() % vertices), std::uint32_t(random() % vertices),
                                  std::uint32_t(random() % vertices)};
            mesh.triangles.push_back(one);
            if (random() % 2 == 0) mesh.triangles.push_back({one[0], one[2], one[1]});
        }
        if (round % 3 == 0) {  // each with its back: closed
            const auto some = mesh.triangles;
            for (const Triangle& t : some) mesh.triangles.push_back({t[0], t[2], t[1]});
        }
        const EdgeBalance expected = balanceByMap(mesh), found = edgeBalance(mesh);
        ASSERT_EQ(found.odd, expected.odd) << round;
        ASSERT_EQ(found.against, expected.against) << round;
        ++(found.closed() ? closed : open);
    }
    EXPECT_GE(closed, 100);
    EXPECT_GE(open, 100);
}

TEST(EdgeBalance, BodiesThatTouchAlongAnEdgeAreClosed) {
    TriangleMesh mesh = test::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    const TriangleMesh second = test::box(Vec3(1, 1, 0), Vec3(2, 2, 1));
    for (Triangle triangle : second.triangles) {  // its vertices 0 and 4 are the first one's 3 and 7
        for (std::uint32_t& vertex : triangle) vertex = vertex == 0 ? 3 : vertex == 4 ? 7 : vertex + 8;
        mesh.triangles.push_back(triangle);
    }
    mesh.vertices.insert(mesh.vertices.end(), second.vertices.begin(), second.vertices.end());
    EXPECT_TRUE(edgeBalance(mesh).closed());
    std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
    EXPECT_EQ(edgeBalance(mesh).odd, 0u);
    EXPECT_EQ(edgeBalance(mesh).against, 3u);
}

}  // namespace
}  // namespace tactooth
