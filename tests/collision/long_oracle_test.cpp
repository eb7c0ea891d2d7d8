// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The full number of poses and directions. Takes minutes.
#include <gtest/gtest.h>

#include <algorithm>

#include "collision/contact_checks.h"

namespace tactooth {
namespace {

/// The number of poses for a tooth and a tool: the oracle is slow for millions of pairs of triangles.
int fewerIfLarge(int poses, const test::NamedMesh& tooth, const test::NamedMesh& tool) {
    if (tooth.mesh.triangles.size() > 100000) poses /= 10;
    if (tool.mesh.triangles.size() > 1000) poses /= 10;
    return poses;
}

}  // namespace

TEST(LongContactOracle, NoneOfAHundredThousandPosesIsMissed) {
    int poses = 0;
    int touching = 0;
    const int share = 130000 / static_cast<int>(test::everyTooth().size() * test::everyKindOfTool().size());
    for (unsigned seed = 1; poses < 100000; ++seed) {
        for (const test::NamedMesh& tooth : test::everyTooth()) {
            for (const test::NamedMesh& tool : test::everyKindOfTool()) {
                const int some = fewerIfLarge(share, tooth, tool);
                const test::TouchReport report = test::checkTouch(tooth.mesh, tool.mesh, some, seed);
                EXPECT_EQ(report.wrong, 0) << tooth.name << " " << tool.name << " " << seed;
                poses += some;
                touching += report.touching;
            }
        }
    }
    EXPECT_GT(touching, poses / 2);
    EXPECT_LT(touching, poses * 95 / 100);
}

TEST(LongContactOracle, EveryDepthFreesAndIsNearlyTheLeastOfAThousandDirections) {
    std::vector<double> excess;
    const int pairs = static_cast<int>(test::everyTooth().size() * test::everyKindOfTool().size());
    const int share = std::max(100, 2000 / pairs);
    for (const test::NamedMesh& tooth : test::everyTooth()) {
        for (const test::NamedMesh& tool : test::everyKindOfTool()) {
            SCOPED_TRACE(tooth.name + " " + tool.name);
            const int poses = fewerIfLarge(share, tooth, tool);
            const test::ContactReport report = test::checkContact(tooth.mesh, tool.mesh, poses, 1000, 2024);
            EXPECT_EQ(report.wrongTouch, 0);
            EXPECT_EQ(report.notFreed, 0);
            EXPECT_EQ(report.freedEarly, 0);
            EXPECT_LE(test::excessAt(report, 0.9), 1.05);
            EXPECT_LE(test::excessAt(report, 0.99), 1.25);
            excess.insert(excess.end(), report.excess.begin(), report.excess.end());
        }
    }
    EXPECT_GT(excess.size(), 1000U);
}

TEST(LongContactOracle, FourHundredPosesOfEveryPairAreFreedByTheirDepth) {
    for (const test::NamedMesh& tooth : test::everyTooth()) {
        for (const test::NamedMesh& tool : test::everyKindOfTool()) {
            SCOPED_TRACE(tooth.name + " " + tool.name);
            const test::ContactReport report =
                test::checkContact(tooth.mesh, tool.mesh, fewerIfLarge(400, tooth, tool), 0, 4);
            EXPECT_EQ(report.notFreed, 0);
            EXPECT_EQ(report.freedEarly, 0);
        }
    }
}

}  // namespace tactooth
