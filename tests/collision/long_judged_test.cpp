// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The full number of poses and directions: minutes.
#include <gtest/gtest.h>

#include "collision/judged_contact.h"

namespace tactooth {

TEST(LongJudgedContact, DepthIsNearlyTheLeastOfAThousandDirectionsOnEveryTooth) {
    for (const test::NamedMesh& tooth : test::judgedTeeth()) {
        for (std::size_t tool = 0; tool < 2; ++tool) {
            SCOPED_TRACE(tooth.name + " " + test::judgedTools()[tool].name);
            const test::ContactVerdict verdict =
                test::judgeContact(tooth.mesh, test::judgedTools()[tool].mesh, 200, 1000, 2024);
            EXPECT_EQ(verdict.wrongTouch, 0);
            EXPECT_EQ(verdict.notFreed, 0);
            EXPECT_EQ(verdict.freedEarly, 0);
            EXPECT_LE(test::excessAt(verdict, 0.9), 1.05);
            EXPECT_LE(test::excessAt(verdict, 0.99), 1.25);
        }
    }
}

}  // namespace tactooth
