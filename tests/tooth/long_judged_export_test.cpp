// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// As judged_export_test.cpp, but until little is left.
#include <gtest/gtest.h>

#include "instruments/builtin_tooth.h"
#include "support/shapes.h"
#include "tooth/judged_cutting.h"

namespace tactooth {
namespace {

TEST(LongJudgedExport, BallsAreSoundUntilLittleIsLeft) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        test::expectSoundThroughout(test::sphere(Vec3(0.03, -0.02, -2), 2, 96, 64),
                                    {.seed = seed, .strokes = 120, .look = 20, .leastRemoved = 0.5});
    }
}

TEST(LongJudgedExport, PlatesAreSoundUntilLittleIsLeft) {
    for (const unsigned seed : {1U, 2U, 4U}) {  // seed 3: see the known fault in docs/cutting.md
        test::expectSoundThroughout(test::box(Vec3(-2.5, -2.5, -0.3), Vec3(2.5, 2.5, 0)),
                                    {.seed = seed, .strokes = 120, .look = 20, .leastRemoved = 0.5});
    }
}

TEST(LongJudgedExport, TeethAreSoundThroughHundredsOfStrokes) {
    test::expectSoundThroughout(makeBuiltinTooth(BuiltinToothKind::lowerFirstMolar, 8000).outer,
                                {.seed = 1, .strokes = 300, .look = 100, .leastRemoved = 0.4});
    test::expectSoundThroughout(makeBuiltinTooth(BuiltinToothKind::upperCentralIncisor, 8000).outer,
                                {.seed = 2, .strokes = 200, .look = 100, .leastRemoved = 0.4});
}

}  // namespace
}  // namespace tactooth
