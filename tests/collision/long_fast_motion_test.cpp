// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Every tooth and several burs at every speed. Takes minutes.
#include <gtest/gtest.h>

#include "collision/fast_motion.h"

namespace tactooth {
namespace {

class LongFastMotion : public ::testing::TestWithParam<double> {};
class LongFastMotionOnManyPaths : public LongFastMotion {};

std::string speedName(const ::testing::TestParamInfo<double>& speed) {
    return std::to_string(static_cast<int>(speed.param)) + "MmPerSecond";
}

}  // namespace

TEST_P(LongFastMotion, OverEveryToothIsExact) {
    for (const test::NamedMesh& tooth : test::everyTooth()) {
        for (const std::size_t tool : {0, 1}) {
            const test::NamedMesh& bur = test::oracleTools()[tool];
            const int strokes = test::fewStrokes(GetParam());
            const test::SpeedReport report = test::checkOverTooth(tooth.mesh, bur.mesh, GetParam(), strokes, 50);
            EXPECT_EQ(report.wrong, 0) << tooth.name << " " << bur.name << ": of " << report.ticks << " ticks, first "
                                       << report.firstWrong << ", worst " << report.worst << " mm";
            EXPECT_EQ(report.intersecting, 0) << tooth.name << " " << bur.name;
        }
    }
}

// At least four times as many paths.
TEST_P(LongFastMotionOnManyPaths, IsExactOverEveryTooth) {
    const int subSteps = GetParam() < 50 ? 5 : 50;  // of two micrometres or more; a slow path has many ticks
    for (const test::NamedMesh& tooth : test::everyTooth()) {
        for (const std::size_t tool : {0, 1}) {
            const test::NamedMesh& bur = test::oracleTools()[tool];
            const test::SpeedReport report = test::checkOverTooth(tooth.mesh, bur.mesh, GetParam(), 24, subSteps);
            EXPECT_EQ(report.wrong, 0) << tooth.name << " " << bur.name << ": of " << report.ticks << " ticks, first "
                                       << report.firstWrong << ", worst " << report.worst << " mm";
            EXPECT_EQ(report.intersecting, 0) << tooth.name << " " << bur.name;
        }
    }
}

TEST_P(LongFastMotion, OnTenPatchesIsExactWithEveryKindOfTool) {
    const TenPatches piece = makeTenPatches();
    for (const test::NamedMesh& tool : test::everyKindOfTool()) {
        for (const Vec3& place : {piece.a, piece.b, piece.c}) {
            const test::SpeedReport report = test::checkOverPatches(piece, tool.mesh, place, GetParam());
            EXPECT_EQ(report.wrong, 0) << tool.name << ": of " << report.ticks << " ticks, first " << report.firstWrong
                                       << ", worst " << report.worst << " mm";
            EXPECT_EQ(report.intersecting, 0) << tool.name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(AtEverySpeed, LongFastMotion, ::testing::ValuesIn(test::kTipSpeeds), speedName);
INSTANTIATE_TEST_SUITE_P(AtEverySpeed, LongFastMotionOnManyPaths, ::testing::ValuesIn(test::kTipSpeeds), speedName);

}  // namespace tactooth
