// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// As oracle_export_test.cpp, but until little is left.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

#include "geometry/io/stl_reader.h"
#include "instruments/builtin_tooth.h"
#include "support/mesh_checks.h"
#include "support/sanitizer.h"
#include "support/shapes.h"
#include "support/test_data.h"
#include "tooth/oracle_cutting.h"
#include "tooth/random_cutting.h"

namespace tactooth {
namespace {

/// The user sees the surface after every move, and not only after every stroke.
void expectClosedAfterEveryMove(TriangleMesh outer, unsigned seed, int strokes) {
    test::RandomCutting tooth(std::move(outer), 0.05, {"2", "57", "35", "170", "330"}, seed);
    int moves = 0;
    int open = 0;
    tooth.checkAfterEachMove([&] {
        ++moves;
        open += test::openEdges(tooth.mesh()) != 0;
    });
    for (int stroke = 0; stroke < strokes; ++stroke) tooth.stroke();
    EXPECT_EQ(open, 0) << "of " << moves << " moves";
    EXPECT_GT(moves, 10 * strokes);
}

TEST(LongOracleExport, ABallIsClosedAfterEveryMove) {
    expectClosedAfterEveryMove(test::sphere(Vec3(0.03, -0.02, -2), 2, 96, 64), 2, 15);
}

TEST(LongOracleExport, APlateIsClosedAfterEveryMove) {
    expectClosedAfterEveryMove(test::box(Vec3(-2.5, -2.5, -0.3), Vec3(2.5, 2.5, 0)), 3, 40);
}

/// Teeth from CT, one of them with 325,312 triangles.
std::map<std::string, TriangleMesh> scans() {
    const auto folder = test::realTeethFolder();
    if (!folder) {
        std::printf("The scanned teeth are not there; a built-in one stands in.\n");
        return {{"built-in", makeBuiltinTooth(BuiltinToothKind::LowerFirstMolar, 20000).outer}};
    }
    std::map<std::string, TriangleMesh> teeth;
    for (const char* name : {"openmandible/whole/L6_whole.stl", "microct-meshes/tooth_2_outer.stl"}) {
        teeth[name] = *readStl(*folder / name);
    }
    return teeth;
}

/// After each stroke all detached pieces are removed.
void expectOnePieceAfterEveryStroke(TriangleMesh outer, unsigned seed, int strokes) {
    test::RandomCutting tooth(std::move(outer), 0.05, {"2", "57", "35", "170", "330"}, seed);
    std::size_t detached = 0;
    for (int stroke = 1; stroke <= strokes; ++stroke) {
        tooth.stroke();
        detached += tooth.removeDetached();
        const TriangleMesh mesh = tooth.exported();
        if (mesh.triangles.empty()) break;
        const test::ExportCheck check = test::checkExportOf(mesh);
        SCOPED_TRACE(::testing::Message() << "seed " << seed << ", stroke " << stroke);
        EXPECT_TRUE(check.isValid()) << check;
        EXPECT_EQ(test::openEdges(tooth.mesh()), 0);  // includes the specks that files leave out
        EXPECT_EQ(test::pieceVolumes(mesh).size(), 1U) << check;
        EXPECT_NEAR(tooth.whole() - check.volume, tooth.removed(), 0.003 * tooth.removed() + 1e-4);
    }
    EXPECT_GT(detached, 10U);
}

TEST(LongOracleExport, ABallStaysInOnePiece) {
    expectOnePieceAfterEveryStroke(test::sphere(Vec3(0.03, -0.02, -2), 2, 96, 64), 1, 30);
}

TEST(LongOracleExport, APlateStaysInOnePiece) {
    expectOnePieceAfterEveryStroke(test::box(Vec3(-2.5, -2.5, -0.3), Vec3(2.5, 2.5, 0)), 2, 40);
    expectOnePieceAfterEveryStroke(test::box(Vec3(-2.5, -2.5, -0.3), Vec3(2.5, 2.5, 0)), 3, 45);
}

TEST(LongOracleExport, BallsAreSoundUntilLittleIsLeft) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        test::expectValidThroughout(test::sphere(Vec3(0.03, -0.02, -2), 2, 96, 64),
                                    {.seed = seed, .strokes = 120, .interval = 20, .leastRemoved = 0.5});
    }
}

/// Finds errors that occur once in some hundred strokes.
TEST(LongOracleExport, BallsByTheDozenAreClosed) {
    const unsigned last = test::cases(160U, 104U);
    for (unsigned seed = 101; seed <= last; ++seed) {
        test::expectClosedAfter(test::sphere(Vec3(0.03, -0.02, -2), 2, 96, 64), {.seed = seed, .strokes = 12});
    }
}

TEST(LongOracleExport, PlatesAreSoundUntilLittleIsLeft) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        test::expectValidThroughout(test::box(Vec3(-2.5, -2.5, -0.3), Vec3(2.5, 2.5, 0)),
                                    {.seed = seed, .strokes = 120, .interval = 20, .leastRemoved = 0.5});
    }
}

TEST(LongOracleExport, TeethAreSoundThroughHundredsOfStrokes) {
    test::expectValidThroughout(makeBuiltinTooth(BuiltinToothKind::LowerFirstMolar, 8000).outer,
                                {.seed = 3, .strokes = 300, .interval = 100, .leastRemoved = 0.4});
    test::expectValidThroughout(makeBuiltinTooth(BuiltinToothKind::UpperCentralIncisor, 8000).outer,
                                {.seed = 2, .strokes = 200, .interval = 100, .leastRemoved = 0.4});
}

TEST(LongOracleExport, ScansAreSoundAtTheVoxelOfEverydayUse) {
    for (const auto& [name, surface] : scans()) {
        SCOPED_TRACE(name);
        test::expectValidThroughout(surface,
                                    {.seed = 2, .strokes = 8, .interval = 4, .voxel = 0.025, .leastRemoved = 0});
    }
}

}  // namespace
}  // namespace tactooth
