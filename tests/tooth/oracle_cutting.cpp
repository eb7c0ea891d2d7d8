// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/oracle_cutting.h"

#include <gtest/gtest.h>

#include "geometry/io/stl_writer.h"
#include "support/mesh_checks.h"
#include "support/test_data.h"

namespace tactooth::test {
namespace {

const std::vector<std::string> kBurs{"2", "57", "35", "170", "330"};

constexpr double kVolumeBound = 0.004;  // relative difference of the surface's volume from the counted one
/// mm. A float at 8 mm is exact to 5e-7. A triangle whose corners are off by that crosses its neighbour by as much.
constexpr double kRounding = 1e-5;
/// Limits: the share of the facets that may cross another one deeper than kRounding, beside a few, and the depth in
/// voxels (docs/cutting.md). Measured: 1.3e-3 and 0.38. If little of the tooth is left, nearly all facets are walls:
/// 3e-3 of a ball of which a twenty-seventh is left.
constexpr double kMaxCrossings = 2e-3, kMaxDebrisVolume = 4e-3;
constexpr double kDebris = 0.05;
constexpr double kCrossingsBeside = 10;
constexpr double kDeepestCrossing = 0.4;

void expectSound(const ExportCheck& verdict, double shareLeft, double voxel) {
    const double most = shareLeft < kDebris ? kMaxDebrisVolume : kMaxCrossings;
    EXPECT_TRUE(verdict.isValid()) << verdict;
    EXPECT_EQ(verdict.collapsed, 0U) << verdict;
    EXPECT_LE(static_cast<double>(verdict.intersectionsDeeperThan(kRounding)),
              most * static_cast<double>(verdict.facets) + kCrossingsBeside)
        << verdict;
    EXPECT_LE(verdict.deepestIntersection(), kDeepestCrossing * voxel) << verdict;
}

}  // namespace

ExportCheck judged(const TriangleMesh& mesh) {
    const TemporaryFolder folder;
    EXPECT_TRUE(writeStl(mesh, folder / "cut.stl"));
    return checkExport(folder / "cut.stl");
}

void expectValidThroughout(TriangleMesh outer, const OracleCutting& cutting) {
    RandomCutting tooth(std::move(outer), cutting.voxel, kBurs, cutting.seed);
    for (int stroke = 1; stroke <= cutting.strokes; ++stroke) {
        tooth.stroke();
        if (stroke % cutting.check != 0) continue;
        const TriangleMesh mesh = tooth.exported();
        if (mesh.triangles.empty()) break;  // nothing is left
        SCOPED_TRACE(::testing::Message() << "seed " << cutting.seed << ", stroke " << stroke);
        EXPECT_EQ(openEdges(tooth.mesh()), 0);  // includes the specks that files leave out
        const ExportCheck verdict = judged(mesh);
        expectSound(verdict, 1 - tooth.removed() / tooth.whole(), cutting.voxel);
        EXPECT_NEAR(tooth.whole() - verdict.volume, tooth.removed(), kVolumeBound * tooth.removed() + 1e-3);
    }
    EXPECT_GT(tooth.removed(), cutting.leastRemoved * tooth.whole());
}

void expectClosedAfter(TriangleMesh outer, const OracleCutting& cutting) {
    SCOPED_TRACE(::testing::Message() << "seed " << cutting.seed << ", strokes " << cutting.strokes);
    RandomCutting tooth(std::move(outer), cutting.voxel, kBurs, cutting.seed);
    for (int stroke = 0; stroke < cutting.strokes; ++stroke) tooth.stroke();
    EXPECT_EQ(openEdges(tooth.mesh()), 0);
    EXPECT_EQ(tooth.failures(), 0U);
    EXPECT_GT(tooth.removed(), cutting.leastRemoved * tooth.whole());
}

}  // namespace tactooth::test
