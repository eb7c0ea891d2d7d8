// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The stateless depth on every available tooth, checked by exact geometry. The full numbers are in
// long_oracle_test.cpp.
#include <gtest/gtest.h>

#include "collision/contact_checks.h"
#include "support/sanitizer.h"

namespace tactooth {
namespace {

constexpr int kPosesOfAPair = test::cases(12, 3);
constexpr std::size_t kSmallTool = 400;  // triangles: a finer tool belongs to the long tests

}  // namespace

TEST(ExactContact, NoneOfTwoThousandPosesIsMissed) {
    constexpr int kWanted = test::cases(2000, 200);
    int poses = 0;
    int touching = 0;
    for (const test::NamedMesh& tooth : test::everyTooth()) {
        for (const test::NamedMesh& tool : test::everyKindOfTool()) {
            const bool coarse = tool.mesh.triangles.size() < kSmallTool && tooth.mesh.triangles.size() < 100000;
            const int share = coarse ? kWanted * 11 / 10 / static_cast<int>(4 * test::everyTooth().size()) + 1 : 3;
            const test::TouchReport report = test::checkTouch(tooth.mesh, tool.mesh, share, 17);
            EXPECT_EQ(report.wrong, 0) << tooth.name << " " << tool.name;
            poses += share;
            touching += report.touching;
        }
    }
    EXPECT_GE(poses, kWanted);
    EXPECT_GT(touching, poses / 2);
    EXPECT_LT(touching, poses * 95 / 100);
}

TEST(ExactContact, TheDepthFreesEveryToolOnEveryToothAndATenthOfAMicrometreLessDoesNot) {
    for (const test::NamedMesh& tooth : test::everyTooth()) {
        for (const test::NamedMesh& tool : test::everyKindOfTool()) {
            if (tool.mesh.triangles.size() > kSmallTool) continue;
            SCOPED_TRACE(tooth.name + " " + tool.name);
            const test::ContactReport report = test::checkContact(tooth.mesh, tool.mesh, kPosesOfAPair, 0, 23);
            EXPECT_EQ(report.wrongTouch, 0);
            EXPECT_EQ(report.notFreed, 0);
            EXPECT_EQ(report.freedEarly, 0);
            EXPECT_GT(report.touching, kPosesOfAPair / 3);
        }
    }
}

// Poses that barely touch or barely do not: half a nanometre on either side of the depth found.
TEST(ExactContact, TouchingIsDecidedToHalfANanometre) {
    for (const test::NamedMesh& tooth : test::oracleTeeth()) {
        const TriangleMesh& tool = test::oracleTools()[0].mesh;
        const test::Oracle oracle(tooth.mesh, tool);
        ContactQuery query(test::toolOf(tool), test::surfaceOf(tooth.mesh));
        std::mt19937 random(31);
        int free = 0;
        constexpr int kPoses = test::cases(40, 5);
        for (int i = 0; i < kPoses;) {
            const Pose pose = test::randomPoseNear(tooth.mesh, 0.5, random);
            const Contact contact = query.at(pose);
            if (!contact.touching) continue;
            ++i;
            for (const double beside : {-5e-7, 5e-7}) {
                const Pose grazing{pose.position + (contact.depth + beside) * contact.normal, pose.rotation};
                ASSERT_EQ(query.isFree(grazing), oracle.isFree(grazing)) << tooth.name << " " << i << " " << beside;
                free += oracle.isFree(grazing) ? 1 : 0;
            }
        }
        EXPECT_EQ(free, kPoses) << tooth.name;  // all of the outer ones and none of the inner
    }
}

}  // namespace tactooth
