// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/jaw_frame.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

/// Teeth of 8 x 8 x 22 mm on a circle of 25 mm around the origin, in units of `mm`; the enamel is their upper half.
std::vector<Scan> arch(int count, double mm) {
    std::vector<Scan> teeth;
    for (int i = 0; i < count; ++i) {
        const Vec3 at(25 * std::cos(0.3 * i), 25 * std::sin(0.3 * i), 0);
        const Vec3 low = (at - Vec3(4, 4, 11)) / mm, high = (at + Vec3(4, 4, 11)) / mm;
        teeth.push_back({std::string("T").append(std::to_string(i)),
                         test::box(low, high),
                         {{"enamel", test::kEnamel, test::box(Vec3(low.x(), low.y(), at.z()), high)}}});
    }
    return teeth;
}

TEST(JawFrame, TheTeethShareOneUnitWhichIsExplained) {
    auto teeth = arch(5, 10);
    teeth[0] = {"chip", test::box(Vec3(2.5, 0, 0), Vec3(2.6, 0.1, 0.1)), {}};  // alone it would count as inches
    const auto jaw = findJawFrame(teeth, std::nullopt);
    ASSERT_TRUE(jaw);
    EXPECT_EQ(jaw->mmPerUnit, 10);
    ASSERT_EQ(jaw->why.size(), 1u);
    EXPECT_EQ(jaw->why[0].topic, ImportNoteTopic::Units);
}

TEST(JawFrame, AUnitThatIsGivenNeedsNoReason) {
    const auto jaw = findJawFrame(arch(3, 10), 25.4);
    ASSERT_TRUE(jaw);
    EXPECT_EQ(jaw->mmPerUnit, 25.4);
    EXPECT_TRUE(jaw->why.empty());
}

TEST(JawFrame, CheeksFaceAwayFromTheMiddleOfTheArch) {
    const auto jaw = findJawFrame(arch(5, 10), std::nullopt);
    ASSERT_TRUE(jaw);
    ASSERT_EQ(jaw->buccalDirections.size(), 5u);
    for (int i = 0; i < 5; ++i) {
        const Vec3 outward(25 * std::cos(0.3 * i), 25 * std::sin(0.3 * i), 0);
        EXPECT_LT((jaw->buccalDirections[static_cast<std::size_t>(i)] - outward).norm(), 1e-4) << i;
    }
}

TEST(JawFrame, TwoTeethDoNotTellWhereTheirCheeksAre) {
    const auto jaw = findJawFrame(arch(2, 1), std::nullopt);
    ASSERT_TRUE(jaw);
    EXPECT_TRUE(jaw->buccalDirections.empty());
}

TEST(JawFrame, AScanWithoutASurfaceIsNamed) {
    auto teeth = arch(2, 1);
    TriangleMesh point;
    point.vertices = {Vec3f(1, 2, 3), Vec3f(1, 2, 3), Vec3f(1, 2, 3)};
    point.triangles = {{0, 1, 2}};
    for (const TriangleMesh& nothing : {TriangleMesh(), point}) {
        teeth[1] = {"void", nothing, {}};
        const auto jaw = findJawFrame(teeth, std::nullopt);
        ASSERT_FALSE(jaw);
        EXPECT_EQ(jaw.error().message(), "void: there is no surface.");
    }
}

}  // namespace
}  // namespace tactooth
