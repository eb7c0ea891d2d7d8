// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Checks files after random cutting with a reader that shares no code with the program.
#include <gtest/gtest.h>

#include "geometry/io/stl_writer.h"
#include "instruments/builtin_tooth.h"
#include "support/sanitizer.h"
#include "support/shapes.h"
#include "tooth/oracle_cutting.h"

namespace tactooth {
namespace {

TEST(OracleExport, AnUncutToothIsSound) {
    const test::ExportCheck check = test::checkExportOf(makeBuiltinTooth(BuiltinToothKind::LowerFirstMolar).outer);
    EXPECT_TRUE(check.isValid()) << check;
    EXPECT_EQ(check.components, 1U);
    EXPECT_TRUE(check.intersections.empty()) << check;
}

/// An oracle is of use only if it finds faults.
TEST(OracleExport, TheOracleFindsEachFault) {
    const TriangleMesh ball = test::sphere(Vec3::Zero(), 1, 24, 16);
    EXPECT_TRUE(test::checkExportOf(ball).isValid());
    TriangleMesh open = ball;
    open.triangles.pop_back();
    EXPECT_TRUE(test::checkExportOf(open).isManifold);
    EXPECT_FALSE(test::checkExportOf(open).isClosed);
    TriangleMesh turned = ball;
    std::swap(turned.triangles[7][0], turned.triangles[7][1]);
    EXPECT_FALSE(test::checkExportOf(turned).isManifold);
    TriangleMesh insideOut = ball;
    for (Triangle& triangle : insideOut.triangles) std::swap(triangle[0], triangle[1]);
    EXPECT_TRUE(test::checkExportOf(insideOut).isClosed);
    EXPECT_FALSE(test::checkExportOf(insideOut).isValid());
    TriangleMesh pinched = test::box(Vec3(-1, -1, -1), Vec3(0, 0, 0));
    append(pinched, test::box(Vec3(0, 0, 0), Vec3(1, 1, 1)));
    EXPECT_FALSE(test::checkExportOf(pinched).isManifold);
    TriangleMesh dented = ball;
    dented.vertices[100] *= -1.2F;
    EXPECT_GT(test::checkExportOf(dented).deepestIntersection(), 0.1);
}

TEST(OracleExport, ABallIsSoundThroughRandomCutting) {
    test::expectValidThroughout(test::sphere(Vec3(0.03, -0.02, -2), 2, 96, 64),
                                {.seed = 3, .strokes = test::cases(12, 4)});
}

/// In these two balls a wall folds over itself where it meets the ball's own surface. This once left a hole: the cut
/// lines of one edge made contradictory statements about its ends.
TEST(OracleExport, ABallIsClosedWhereItsWallFoldsAtAnEdge) {
    const TriangleMesh ball = test::sphere(Vec3(0.03, -0.02, -2), 2, 96, 64);
    test::expectClosedAfter(ball, {.seed = 124, .strokes = 4});
    test::expectClosedAfter(ball, {.seed = 107, .strokes = 12});
}

/// Here the wall needs a node of a brick that no bur was near.
TEST(OracleExport, ABallIsClosedWhereAWallEndsInTheCornerOfABrick) {
    test::expectClosedAfter(test::sphere(Vec3(0.03, -0.02, -2), 2, 96, 64),
                            {.seed = 510, .strokes = 7, .voxel = 0.025, .leastRemoved = 0.02});
}

TEST(OracleExport, APlateIsSoundThroughRandomCutting) {
    test::expectValidThroughout(test::box(Vec3(-2.5, -2.5, -0.3), Vec3(2.5, 2.5, 0)),
                                {.seed = 2, .strokes = test::cases(20, 4)});
}

TEST(OracleExport, AMolarIsSoundThroughRandomCutting) {
    test::expectValidThroughout(makeBuiltinTooth(BuiltinToothKind::LowerFirstMolar, 8000).outer,
                                {.seed = 5, .strokes = 8, .interval = 8, .leastRemoved = 0.02});
}

}  // namespace
}  // namespace tactooth
