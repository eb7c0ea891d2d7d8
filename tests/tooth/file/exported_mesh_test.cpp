// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/file/exported_mesh.h"

#include <gtest/gtest.h>

#include "support/expect_assert.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kVoxel = 0.05;  // mm
const Vec3 kFar(3, 0, 0), kFarther(4, 0, 0);

TriangleMesh cubeAt(const Vec3& low, double side) { return test::box(low, low + Vec3::Constant(side)); }

std::shared_ptr<const SurfacePart> part(TriangleMesh mesh, SurfaceTag tag) {
    std::vector<SurfaceTag> tags(mesh.triangles.size(), tag);
    return std::make_shared<const SurfacePart>(std::move(mesh), std::move(tags));
}

/// With the vertex numbers of an uncut tooth's file.
TriangleMesh untouched(const TriangleMesh& mesh) { return visibleMesh({.base = part(mesh, 0)}).mesh; }

TEST(ExportedMesh, LeavesOutWhatCuttingLeftBelowAVoxel) {
    const auto base = part(cubeAt(Vec3::Zero(), 1), 1);
    const auto speck = part(cubeAt(kFar, 0.99 * kVoxel), 2);
    const auto piece = part(cubeAt(kFarther, 1.01 * kVoxel), 3);
    const TaggedMesh exported = exportedMesh({.base = base, .patches = {speck, piece}}, kVoxel);
    TriangleMesh expected = base->mesh();
    append(expected, piece->mesh());
    EXPECT_TRUE(test::areBitEqual(exported.mesh, untouched(expected)));
    std::vector<SurfaceTag> tags(12, 1);
    tags.resize(24, 3);
    EXPECT_EQ(exported.tags, tags);
}

TEST(ExportedMesh, ASpeckThatIsTurnedInsideOutGoesToo) {
    TriangleMesh turned = cubeAt(kFar, 0.5 * kVoxel);
    for (Triangle& triangle : turned.triangles) std::swap(triangle[0], triangle[1]);
    const auto base = part(cubeAt(Vec3::Zero(), 1), 1);
    const TaggedMesh exported = exportedMesh({.base = base, .patches = {part(turned, 2)}}, kVoxel);
    EXPECT_TRUE(test::areBitEqual(exported.mesh, untouched(base->mesh())));
}

/// Half of its triangles belong to the base, and the patch closes them.
TEST(ExportedMesh, ASpeckMayHaveSomeOfTheToothsOwnSurface) {
    TriangleMesh all = cubeAt(Vec3::Zero(), 1);
    append(all, cubeAt(kFar, 0.5 * kVoxel));
    TriangleMesh own = all;
    own.triangles.resize(18);
    TriangleMesh walls = all;
    walls.triangles.erase(walls.triangles.begin(), walls.triangles.begin() + 18);
    const TaggedMesh exported = exportedMesh({.base = part(own, 1), .patches = {part(walls, 2)}}, kVoxel);
    EXPECT_TRUE(test::areBitEqual(exported.mesh, untouched(cubeAt(Vec3::Zero(), 1))));
}

TEST(ExportedMesh, WhatNoBurHasTouchedStaysHoweverSmall) {
    TriangleMesh whole = cubeAt(Vec3::Zero(), 1);
    append(whole, cubeAt(kFar, 0.1 * kVoxel));
    const auto base = part(whole, 1);
    EXPECT_TRUE(test::areBitEqual(exportedMesh({.base = base}, kVoxel).mesh, untouched(whole)));
    // ... and with hidden triangles before them.
    const auto hidden = std::make_shared<TriangleMask>(TriangleMask{0xFFF});
    const auto again = part(cubeAt(Vec3::Zero(), 1), 2);
    const TaggedMesh exported = exportedMesh(
        {.base = base, .hidden = hidden, .patches = {again, part(cubeAt(kFarther, 0.1 * kVoxel), 3)}}, kVoxel);
    EXPECT_EQ(exported.mesh.triangles.size(), 24U);
    EXPECT_EQ(exported.tags.front(), 1);
    EXPECT_EQ(exported.tags.back(), 2);
}

TEST(ExportedMeshAsserts, AVoxelHasASize) {
    const auto ball = std::make_shared<const SurfacePart>(test::sphere(Vec3::Zero(), 1, 16, 8));
    EXPECT_ASSERT(static_cast<void>(exportedMesh({.base = ball}, 0)));
    EXPECT_ASSERT(static_cast<void>(exportedMesh({.base = nullptr}, 0.1)));
}

}  // namespace
}  // namespace tactooth
