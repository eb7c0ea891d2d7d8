// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/contact_query.h"

#include <gtest/gtest.h>

#include "collision/contact_checks.h"
#include "support/sanitizer.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

Pose at(const Vec3& position) { return {position, Quat::Identity()}; }

/// Two planes at 45 degrees that meet along y, open above.
TriangleMesh groove() {
    TriangleMesh mesh;
    mesh.vertices = {{0, -10, 0}, {0, 10, 0}, {5, 10, 5}, {5, -10, 5}, {-5, 10, 5}, {-5, -10, 5}};
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {0, 4, 5}};
    return mesh;
}

TriangleMesh scaled(TriangleMesh mesh, double scale) {
    for (Vec3f& vertex : mesh.vertices) vertex = (vertex.cast<double>() * scale).cast<float>();
    return mesh;
}

/// A ball of 1 mm whose lowest point is a vertex at the origin.
TriangleMesh ball() { return test::sphere(Vec3(0, 0, 1), 1, 48, 24); }

}  // namespace

TEST(ContactQuery, AgreesWithTheOracleOnRandomPosesOfEveryTooth) {
    for (std::size_t tooth = 0; tooth < test::cases<std::size_t>(3, 1); ++tooth) {
        for (std::size_t tool = 0; tool < 2; ++tool) {
            SCOPED_TRACE(test::oracleTeeth()[tooth].name + " " + test::oracleTools()[tool].name);
            const test::ContactReport report =
                test::checkContact(test::oracleTeeth()[tooth].mesh, test::oracleTools()[tool].mesh, 60, 0, 7);
            EXPECT_EQ(report.wrongTouch, 0);
            EXPECT_EQ(report.notFreed, 0);
            EXPECT_EQ(report.freedEarly, 0);
            EXPECT_GT(report.touching, 20);
        }
    }
}

TEST(ContactQuery, DepthIsNearlyTheLeastThatRandomDirectionsFind) {
    const test::ContactReport report =
        test::checkContact(test::oracleTeeth()[2].mesh, test::oracleTools()[0].mesh, 60, 100, 11);
    EXPECT_LE(test::excessAt(report, 0.9), 1.05);
    EXPECT_LE(test::excessAt(report, 0.99), 1.25);
}

TEST(ContactQuery, ABallInAPlateIsAsDeepAsItsLowestPoint) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        const TriangleMesh plate = scaled(test::box(Vec3(-9, -9, -5), Vec3(9, 9, 0)), scale);
        ContactQuery query(test::toolOf(scaled(ball(), scale)), test::surfaceOf(plate));
        const Contact contact = query.at(at(Vec3(0.3, 0.2, -0.25) * scale));
        ASSERT_TRUE(contact.touching) << scale;
        EXPECT_NEAR(contact.depth / scale, 0.25, 1e-5) << scale;
        EXPECT_NEAR(contact.normal.z(), 1, 1e-9) << scale;
        EXPECT_NEAR((contact.point / scale - Vec3(0.3, 0.2, -0.25)).norm(), 0, 1e-5) << scale;
    }
}

TEST(ContactQuery, ABallOnAnEdgeAndOnACornerLeavesByTheShortestTranslation) {
    const TriangleMesh block = test::box(Vec3(-9, -9, -9), Vec3(0, 0, 0));
    ContactQuery query(test::toolOf(test::sphere(Vec3(0, 0, 0), 1, 96, 48)), test::surfaceOf(block));
    const Vec3 edge = Vec3(1, 0, 1).normalized();
    const Contact onEdge = query.at(at(0.8 * edge - 4 * Vec3::UnitY()));
    EXPECT_NEAR(onEdge.depth, 0.2, 2e-3);  // facets lie up to 2 um below the ball
    EXPECT_NEAR(onEdge.normal.dot(edge), 1, 2e-3);
    const Vec3 corner = Vec3(1, 1, 1).normalized();
    const Contact onCorner = query.at(at(0.8 * corner));
    EXPECT_NEAR(onCorner.depth, 0.2, 3e-3);
    EXPECT_NEAR(onCorner.normal.dot(corner), 1, 3e-3);
}

TEST(ContactQuery, ABallInAVGrooveLeavesUpward) {
    // A ball of 1 mm rests in the groove with its centre sqrt(2) above the bottom. 0.2 mm lower, the exit must
    // leave both planes: it is upward, or along the normal of one wall if that keeps clear of the other.
    ContactQuery query(test::toolOf(test::sphere(Vec3(0, 0, 0), 1, 192, 96)), test::surfaceOf(groove(), false));
    const Contact contact = query.at(at(Vec3(0, 0, std::sqrt(2.0) - 0.2)));
    EXPECT_NEAR(contact.depth, 0.2, 2e-3);
    EXPECT_NEAR(contact.normal.z(), 1, 1e-2);
}

TEST(ContactQuery, GivesTheSameResultAMetreAway) {
    const TriangleMesh& tooth = test::oracleTeeth()[2].mesh;
    const TriangleMesh& tool = test::oracleTools()[0].mesh;
    // Whole multiples of 2^-10 mm stay exact in single precision a metre away.
    TriangleMesh rounded = tooth;
    for (Vec3f& v : rounded.vertices) v = (v * 1024).array().round().matrix() / 1024;
    TriangleMesh moved = rounded;
    for (Vec3f& v : moved.vertices) v += Vec3f(1024, -1024, 1024);
    ContactQuery near(test::toolOf(tool), test::surfaceOf(rounded));
    ContactQuery far(test::toolOf(tool), test::surfaceOf(moved));
    std::mt19937 random(3);
    for (int i = 0; i < test::cases(20, 5); ++i) {
        const Pose pose = test::randomPoseNear(rounded, 0.5, random);
        const Contact here = near.at(pose);
        const Contact there = far.at({pose.position + Vec3(1024, -1024, 1024), pose.rotation});
        ASSERT_EQ(here.touching, there.touching);
        EXPECT_NEAR(here.depth, there.depth, 0.01 * here.depth);  // either of two neighbouring dents may be found
    }
}

TEST(ContactQuery, DetectsMovementsDownToANanometreInOrder) {
    ContactQuery query(test::toolOf(ball()), test::surfaceOf(test::box(Vec3(-9, -9, -5), Vec3(9, 9, 0))));
    for (const double step : {0.1, 0.01, 0.001, 1e-4, 1e-5, 1e-6}) {
        double last = query.at(at(Vec3(0, 0, -0.1))).depth;
        for (int i = 1; i <= 5; ++i) {
            const double depth = query.at(at(Vec3(0, 0, -0.1 - i * step))).depth;
            EXPECT_NEAR(depth - last, step, 1e-3 * step + 1e-9) << step;
            last = depth;
        }
    }
}

TEST(ContactQuery, AResultDoesNotDependOnEarlierQueries) {
    const auto tool = test::toolOf(test::oracleTools()[1].mesh);
    const auto tooth = test::surfaceOf(test::oracleTeeth()[2].mesh);
    std::mt19937 random(5);
    std::vector<Pose> poses;
    for (int i = 0; i < test::cases(30, 6); ++i)
        poses.push_back(test::randomPoseNear(test::oracleTeeth()[2].mesh, 0.5, random));
    ContactQuery query(tool, tooth);
    std::vector<Contact> answers;
    for (const Pose& pose : poses) answers.push_back(query.at(pose));
    for (std::size_t i = poses.size(); i-- > 0;) {
        SCOPED_TRACE(i);
        const Contact again = query.at(poses[i]);
        EXPECT_EQ(again.depth, answers[i].depth);
        EXPECT_EQ(again.normal, answers[i].normal);
        EXPECT_EQ(again.point, answers[i].point);
        EXPECT_EQ(ContactQuery(tool, tooth).at(poses[i]).depth, answers[i].depth);
    }
}

TEST(ContactQuery, AnOpenSurfaceHasNoInside) {
    TriangleMesh plate = test::box(Vec3(-9, -9, -5), Vec3(9, 9, 0));
    ContactQuery open(test::toolOf(test::sphere(Vec3(0, 0, 0), 0.5, 12, 6)), test::surfaceOf(plate, false));
    ContactQuery closed(test::toolOf(test::sphere(Vec3(0, 0, 0), 0.5, 12, 6)), test::surfaceOf(plate, true));
    EXPECT_FALSE(open.at(at(Vec3(0, 0, -2))).touching);
    const Contact enclosed = closed.at(at(Vec3(0, 0, -2)));
    EXPECT_TRUE(enclosed.touching);
    EXPECT_NEAR(enclosed.depth, 2.5, 1e-5);
    EXPECT_EQ(enclosed.contacts, 0);
}

TEST(ContactQuery, PenaltyFreesTheDeepestPairAlone) {
    ContactQuery query(test::toolOf(ball()), test::surfaceOf(test::box(Vec3(-9, -9, -5), Vec3(9, 9, 0))));
    const Contact contact = query.deepestPairAt(at(Vec3(0.3, 0.2, -0.01)));
    ASSERT_TRUE(contact.touching);
    EXPECT_GT(contact.contacts, 0);
    EXPECT_GT(contact.depth, 0);
    EXPECT_LT(contact.depth,
              0.01);  // that of a facet which slopes through the surface: less than that of the whole tool
    EXPECT_NEAR(contact.normal.norm(), 1, 1e-12);
}

}  // namespace tactooth
