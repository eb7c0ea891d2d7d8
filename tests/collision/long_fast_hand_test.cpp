// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Every tooth and several burs at every speed: minutes.
#include <gtest/gtest.h>

#include "collision/fast_hand.h"

namespace tactooth {
namespace {

class LongFastHand : public ::testing::TestWithParam<double> {};
class LongFastHandOnManyWays : public LongFastHand {};

std::string speedName(const ::testing::TestParamInfo<double>& speed) {
    return std::to_string(static_cast<int>(speed.param)) + "MmPerSecond";
}

}  // namespace

TEST_P(LongFastHand, OverEveryToothIsExact) {
    for (const test::NamedMesh& tooth : test::everyTooth()) {
        for (const std::size_t tool : {0, 1}) {
            const test::NamedMesh& bur = test::judgedTools()[tool];
            const int strokes = test::fewStrokes(GetParam());
            const test::SpeedVerdict verdict = test::judgeOverTooth(tooth.mesh, bur.mesh, GetParam(), strokes, 50);
            EXPECT_EQ(verdict.wrong, 0) << tooth.name << " " << bur.name << ": of " << verdict.ticks << " ticks, first "
                                        << verdict.firstWrong << ", worst " << verdict.worst << " mm";
            EXPECT_EQ(verdict.intersecting, 0) << tooth.name << " " << bur.name;
        }
    }
}

// Four times as many ways and more.
TEST_P(LongFastHandOnManyWays, IsExactOverEveryTooth) {
    const int subSteps = GetParam() < 50 ? 5 : 50;  // of two micrometres or more; a slow hand has many ticks
    for (const test::NamedMesh& tooth : test::everyTooth()) {
        for (const std::size_t tool : {0, 1}) {
            const test::NamedMesh& bur = test::judgedTools()[tool];
            const test::SpeedVerdict verdict = test::judgeOverTooth(tooth.mesh, bur.mesh, GetParam(), 24, subSteps);
            EXPECT_EQ(verdict.wrong, 0) << tooth.name << " " << bur.name << ": of " << verdict.ticks << " ticks, first "
                                        << verdict.firstWrong << ", worst " << verdict.worst << " mm";
            EXPECT_EQ(verdict.intersecting, 0) << tooth.name << " " << bur.name;
        }
    }
}

TEST_P(LongFastHand, OnTenPatchesIsExactWithEveryKindOfTool) {
    const TenPatches piece = makeTenPatches();
    for (const test::NamedMesh& tool : test::everyKindOfTool()) {
        for (const Vec3& place : {piece.a, piece.b, piece.c}) {
            const test::SpeedVerdict verdict = test::judgeOverPatches(piece, tool.mesh, place, GetParam());
            EXPECT_EQ(verdict.wrong, 0) << tool.name << ": of " << verdict.ticks << " ticks, first "
                                        << verdict.firstWrong << ", worst " << verdict.worst << " mm";
            EXPECT_EQ(verdict.intersecting, 0) << tool.name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(AtEverySpeed, LongFastHand, ::testing::ValuesIn(test::kTipSpeeds), speedName);
INSTANTIATE_TEST_SUITE_P(AtEverySpeed, LongFastHandOnManyWays, ::testing::ValuesIn(test::kTipSpeeds), speedName);

}  // namespace tactooth
