// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/plane_switch.h"

#include <gtest/gtest.h>

#include "collision/proxy/proxy_fixture.h"
#include "support/expect_assert.h"

namespace tactooth {
namespace {

using test::kMargin;

/// A tool that stands one margin beside and one margin above the edge x = 0 of a flat tooth, which lies at x < 0.
struct EdgeFixture {
    ProxyContext context = test::contextOf(toolMesh(), toothMesh(), test::poseAt(kMargin, 0, kMargin));
    std::vector<WatchedPair> watched;

    /// Two triangles that share the corner at the origin.
    static TriangleMesh toolMesh() {
        TriangleMesh mesh;
        mesh.vertices = {{0, 0, 0}, {2, 1, 3}, {2, -1, 3}, {3, -2, 3}};
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
        return mesh;
    }
    /// The flat triangle, and a wall at x = -1.
    static TriangleMesh toothMesh() {
        TriangleMesh mesh;
        mesh.vertices = {{-9, 0, 0}, {0, -9, 0}, {0, 9, 0}, {-1, -9, -9}, {-1, 9, -9}, {-1, 0, 9}};
        mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
        return mesh;
    }
    WatchedPair pairWith(std::uint32_t tooth, std::uint32_t tool, const Vec3& normal) const {
        WatchedPair pair{{0, tooth, tool}, {}};
        pair.plane = {normal, highestAlong(context.scene.toothTriangle(pair.pair), normal), context.scene.poseStamp};
        return pair;
    }
    /// Adds a contact whose plane stands upright on the edge, and so stops the tool.
    void addUpright(std::uint32_t tool) { watched.push_back(pairWith(0, tool, Vec3::UnitX())); }
    bool run(const Vec3& toGoal, WatchedPair* other = nullptr) {
        PlaneSwitch planes(context, {context.scene.pose.position + toGoal, Quat::Identity()});
        for (WatchedPair& pair : watched) planes.addContact(pair);
        if (other != nullptr) planes.addPair(*other);
        return planes.run();
    }
};

}  // namespace

TEST(PlaneSwitch, DoesNothingWithoutContacts) {
    EdgeFixture fixture;
    EXPECT_FALSE(fixture.run(Vec3(-0.5, 0, 0)));
}

TEST(PlaneSwitch, TakesAPlaneThatLetsTheToolMoveOn) {
    EdgeFixture fixture;
    fixture.addUpright(0);
    EXPECT_TRUE(fixture.run(Vec3(-0.5, 0, 0)));
    const SeparatingPlane& plane = fixture.watched[0].plane;
    EXPECT_LT(plane.normal.x(), 0.1) << "the way to -x is open";
    EXPECT_EQ(plane.stamp, fixture.context.scene.poseStamp);
    const double gap =
        gapAt(*fixture.context.scene.tool, fixture.watched[0], Mat3::Identity(), fixture.context.scene.pose.position);
    EXPECT_GE(gap, 0.25 * kMargin);
}

TEST(PlaneSwitch, RemembersThePlaneThatItTakes) {
    EdgeFixture fixture;
    fixture.addUpright(0);
    ASSERT_TRUE(fixture.run(Vec3(-0.5, 0, 0)));
    const WatchedPair remembered =
        fixture.context.planes.watch(fixture.context.scene, fixture.watched[0].pair, Vec3::Zero());
    EXPECT_EQ(remembered.plane.normal, fixture.watched[0].plane.normal);
}

TEST(PlaneSwitch, SwitchesContactsThatShareACornerTogether) {
    EdgeFixture fixture;
    fixture.addUpright(0);
    fixture.addUpright(1);
    EXPECT_TRUE(fixture.run(Vec3(-0.5, 0, 0)));
    EXPECT_LT(fixture.watched[0].plane.normal.x(), 0.1);
    EXPECT_EQ(fixture.watched[0].plane.normal, fixture.watched[1].plane.normal);
}

TEST(PlaneSwitch, KeepsThePlanesIfNoneLeadsTowardTheGoal) {
    EdgeFixture fixture;
    fixture.context.scene.pose = test::poseAt(-0.5, 0, kMargin);  // over the middle of the face
    fixture.watched.push_back(fixture.pairWith(0, 0, Vec3::UnitZ()));
    EXPECT_FALSE(fixture.run(Vec3(0, 0, -0.5)));
    EXPECT_EQ(fixture.watched[0].plane.normal, Vec3::UnitZ());
}

TEST(PlaneSwitch, DoesNotSwitchForADisplacementBelowTwentyMargins) {
    EdgeFixture fixture;
    fixture.addUpright(0);
    EXPECT_FALSE(fixture.run(Vec3(-19 * kMargin, 0, 0)));
    EXPECT_EQ(fixture.watched[0].plane.normal, Vec3::UnitX());
    EXPECT_TRUE(fixture.run(Vec3(-30 * kMargin, 0, 0)));
}

TEST(PlaneSwitch, CountsThePairsThatBlockTheToolBesideItsContacts) {
    EdgeFixture fixture;
    fixture.context.scene.pose = test::poseAt(kMargin, 0, kMargin);
    fixture.addUpright(0);
    // As if the wall stood right beside the tool.
    WatchedPair wall{{0, 1, 0}, {Vec3::UnitX(), kMargin, fixture.context.scene.poseStamp}};
    EXPECT_FALSE(fixture.run(Vec3(-0.5, 0, 0), &wall));
}

TEST(PlaneSwitch, AssertsThatPlanesAreOfThePresentPoseAndContactsComeFirst) {
    EdgeFixture fixture;
    WatchedPair contact = fixture.pairWith(0, 0, Vec3::UnitX());
    WatchedPair old = contact;
    --old.plane.stamp;
    PlaneSwitch planes(fixture.context, test::poseAt(-1, 0, 0));
    EXPECT_ASSERT(planes.addPair(old));
    planes.addPair(contact);
    EXPECT_ASSERT(planes.addContact(contact));
}

}  // namespace tactooth
