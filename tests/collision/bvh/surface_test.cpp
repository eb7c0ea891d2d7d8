// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/bvh/surface.h"

#include <gtest/gtest.h>

#include "collision/narrow/triangle3.h"
#include "support/expect_assert.h"
#include "support/shapes.h"

namespace tactooth {

TEST(Surface, ShowsTheBaseWithoutItsHiddenTrianglesAndEveryPatch) {
    const auto base = std::make_shared<SurfacePart>(test::box(Vec3(0, 0, 0), Vec3(1, 1, 1)));
    auto hidden = std::make_shared<TriangleMask>(1, std::uint64_t{0b11});
    const auto patch = std::make_shared<SurfacePart>(
        TriangleMesh{{Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)}, {{0, 1, 2}}}, std::vector<SurfaceTag>{3});

    const TaggedMesh visible = visibleMesh({base, hidden, {patch}, 1});

    ASSERT_EQ(visible.mesh.triangles.size(), 11U);
    ASSERT_EQ(visible.tags.size(), 11U);
    EXPECT_EQ(visible.tags.back(), 3);
    for (int corner = 0; corner < 3; ++corner)
        EXPECT_EQ(visible.mesh.corner(0, corner), base->mesh().corner(2, corner));
}

TEST(Surface, WithNothingHiddenIsTheBaseBitForBit) {
    const auto base = std::make_shared<SurfacePart>(test::sphere(Vec3(0, 0, 0), 1, 9, 7));
    const TaggedMesh visible = visibleMesh({base, nullptr, {}, 0});
    ASSERT_EQ(visible.mesh.triangles.size(), base->mesh().triangles.size());
    for (std::size_t i = 0; i < visible.mesh.triangles.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            ASSERT_EQ(visible.mesh.corner(i, corner), base->mesh().corner(i, corner));
        }
    }
}

TEST(SurfacePart, HasAUniqueId) {
    const TriangleMesh mesh = test::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    EXPECT_NE(SurfacePart(mesh).id(), SurfacePart(mesh).id());
}

TEST(VisibleMesh, LeavesOutTrianglesOfPatchesThatRoundingHasCollapsed) {
    TriangleMesh mesh = test::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    const auto whole = mesh.triangles.size();
    mesh.vertices.push_back(mesh.vertices[0]);  // the same position under another number
    mesh.triangles.push_back({0, static_cast<std::uint32_t>(mesh.vertices.size() - 1), 1});
    const auto part = std::make_shared<const SurfacePart>(mesh);
    EXPECT_EQ(visibleMesh({part, nullptr, {}, 0}).mesh.triangles.size(), whole + 1) << "triangles of the file stay";
    const TaggedMesh visible = visibleMesh({part, nullptr, {part}, 0});
    EXPECT_EQ(visible.mesh.triangles.size(), 2 * whole + 1);
    EXPECT_EQ(visible.tags.size(), 2 * whole + 1);
}

TEST(Surface, KeepsItsInvariants) {
    const auto base = std::make_shared<SurfacePart>(test::sphere(Vec3(0, 0, 0), 1, 9, 7));
    const auto patch = std::make_shared<SurfacePart>(test::box(Vec3(0, 0, 0), Vec3(1, 1, 1)));
    const std::size_t words = (base->mesh().triangles.size() + 63) / 64;
    Surface{base, std::make_shared<TriangleMask>(words), {patch}, 1}.validate();
    EXPECT_ASSERT((Surface{base, std::make_shared<TriangleMask>(words + 1), {patch}, 1}.validate()));
    EXPECT_ASSERT((Surface{base, nullptr, {nullptr}, 1}.validate()));
    EXPECT_ASSERT((Surface{nullptr, nullptr, {}, 1}.validate()));
}

TEST(Surface, AssertsThatPartsAndTrianglesExist) {
    const auto base = std::make_shared<SurfacePart>(test::box(Vec3(0, 0, 0), Vec3(1, 1, 1)));
    EXPECT_ASSERT((void)partOf(Surface{base, nullptr, {}, 0}, 1));
    EXPECT_ASSERT((void)base->tag(12));
    EXPECT_ASSERT((void)isHidden(TriangleMask(1), 64));
    EXPECT_ASSERT((void)cornersOf(base->mesh(), 12));
}

}  // namespace tactooth
