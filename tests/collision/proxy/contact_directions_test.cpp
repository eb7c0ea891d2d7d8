// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/contact_directions.h"

#include <gtest/gtest.h>

#include "collision/narrow/gjk.h"
#include "collision/proxy/proxy_fixture.h"
#include "support/expect_assert.h"

namespace tactooth {
namespace {

Triangle3 randomTriangle(std::mt19937& random, const Vec3& centre) {
    return {centre + test::randomVector(random), centre + test::randomVector(random),
            centre + test::randomVector(random)};
}

double widestSlab(const ContactDirections& directions, const Triangle3& tooth, const Triangle3& tool) {
    double widest = -1e9;
    for (int i = 0; i < directions.count(); ++i)
        widest = std::max(widest, lowestAlong(tool, directions[i]) - highestAlong(tooth, directions[i]));
    return widest;
}

}  // namespace

TEST(ContactDirections, AreUnitAndComeInBothSenses) {
    std::mt19937 random(1);
    const ContactDirections directions(randomTriangle(random, Vec3::Zero()), randomTriangle(random, Vec3::Zero()));
    ASSERT_EQ(directions.count(), 22);
    for (int i = 0; i < directions.count(); i += 2) {
        EXPECT_NEAR(directions[i].norm(), 1, 1e-12);
        EXPECT_EQ(directions[i], -directions[i + 1]);
    }
}

TEST(ContactDirections, HoldAPlaneForEachPairOfTrianglesThatAreApart) {
    // The theorem of separating axes: some normal of a face or of a pair of edges separates disjoint triangles.
    std::mt19937 random(2);
    int apart = 0;
    for (int i = 0; i < 2000; ++i) {
        const Triangle3 tooth = randomTriangle(random, Vec3::Zero());
        const Triangle3 tool = randomTriangle(random, test::randomVector(random));
        const bool isApart = distanceBetween(tooth, tool, tool[0] - tooth[0]).separated;
        EXPECT_EQ(widestSlab(ContactDirections(tooth, tool), tooth, tool) > 0, isApart) << i;
        apart += isApart ? 1 : 0;
    }
    EXPECT_GT(apart, 500);
    EXPECT_LT(apart, 1900);
}

TEST(ContactDirections, LeaveOutParallelEdgesAndFacesWithoutArea) {
    const Triangle3 flat{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    EXPECT_EQ(ContactDirections(flat, flat).count(), 2 * (2 + 6)) << "three of the nine pairs of edges are parallel";
    const Triangle3 point{Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)};
    EXPECT_EQ(ContactDirections(flat, point).count(), 2);
}

TEST(ContactDirections, TiltOverAnEdgeByTheGapGiven) {
    // The tool's corner stands beside the middle of the tooth's edge along y, 3 um from it.
    const Triangle3 tooth{Vec3(0, -1, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0)};
    const Triangle3 tool{Vec3(0, 0, 0.003), Vec3(1, 0, 5), Vec3(-1, 0, 5)};
    ContactDirections directions(tooth, tool);
    const int before = directions.count();
    constexpr double kLeast = 0.001;
    directions.addTilted(tooth, tool, kLeast, 0.004 * 0.004);
    ASSERT_EQ(directions.count(), before + 2) << "the other corners are farther than the reach";
    for (int i = before; i < directions.count(); ++i) {
        EXPECT_NEAR(directions[i].norm(), 1, 1e-12);
        EXPECT_NEAR(directions[i].y(), 0, 1e-12) << "the plane holds the edge";
        EXPECT_NEAR(directions[i].dot(tool[0] - tooth[0]), kLeast, 1e-12);
    }
    EXPECT_NEAR(directions[before].x(), -directions[before + 1].x(), 1e-12) << "one to each side";
}

TEST(ContactDirections, TiltOnlyOverEdgesWithinReachAndWithGapToSpare) {
    const Triangle3 tooth{Vec3(0, -1, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0)};
    const Triangle3 tool{Vec3(0, 0, 0.003), Vec3(1, 0, 5), Vec3(-1, 0, 5)};
    ContactDirections directions(tooth, tool);
    const int before = directions.count();
    directions.addTilted(tooth, tool, 0.001, 0.002 * 0.002);
    EXPECT_EQ(directions.count(), before) << "beyond the reach";
    directions.addTilted(tooth, tool, 0.004, 0.004 * 0.004);
    EXPECT_EQ(directions.count(), before) << "the corner is nearer than that already";
}

TEST(ContactDirections, TakeDirectionsOfTheCaller) {
    std::mt19937 random(3);
    ContactDirections directions(randomTriangle(random, Vec3::Zero()), randomTriangle(random, Vec3::Zero()));
    directions.add(Vec3::UnitY());
    EXPECT_EQ(directions[directions.count() - 1], Vec3::UnitY());
    EXPECT_ASSERT(directions.add(Vec3(0, 2, 0)));
    EXPECT_ASSERT((void)directions[directions.count()]);
}

}  // namespace tactooth
