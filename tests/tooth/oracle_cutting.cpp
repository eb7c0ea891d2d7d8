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
/// Limits (docs/cutting.md): the fraction of the facets that may intersect another one deeper than kRounding, a few
/// more in any case, and the depth in voxels. Measured: 0.19 voxels.
constexpr double kMaxIntersecting = 1e-5;
constexpr double kFewIntersecting = 4;
constexpr double kMaxDepth = 0.4;

void expectSound(const ExportCheck& check, double voxel) {
    EXPECT_TRUE(check.isValid()) << check;
    EXPECT_EQ(check.collapsed, 0U) << check;
    EXPECT_LE(static_cast<double>(check.intersectionsDeeperThan(kRounding)),
              kMaxIntersecting * static_cast<double>(check.facets) + kFewIntersecting)
        << check;
    EXPECT_LE(check.deepestIntersection(), kMaxDepth * voxel) << check;
}

}  // namespace

ExportCheck checkExportOf(const TriangleMesh& mesh) {
    const TemporaryFolder folder;
    EXPECT_TRUE(writeStl(mesh, folder / "cut.stl"));
    return checkExport(folder / "cut.stl");
}

void expectValidThroughout(TriangleMesh outer, const OracleCutting& cutting) {
    RandomCutting tooth(std::move(outer), cutting.voxel, kBurs, cutting.seed);
    for (int stroke = 1; stroke <= cutting.strokes; ++stroke) {
        tooth.stroke();
        if (stroke % cutting.interval != 0) continue;
        const TriangleMesh mesh = tooth.exported();
        if (mesh.triangles.empty()) break;  // nothing is left
        SCOPED_TRACE(::testing::Message() << "seed " << cutting.seed << ", stroke " << stroke);
        EXPECT_EQ(openEdges(tooth.mesh()), 0);  // includes the specks that files leave out
        const ExportCheck check = checkExportOf(mesh);
        expectSound(check, cutting.voxel);
        EXPECT_NEAR(tooth.whole() - check.volume, tooth.removed(), kVolumeBound * tooth.removed() + 1e-3);
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
