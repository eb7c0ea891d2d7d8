// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cause/error_patch.h"

#include <gtest/gtest.h>

#include "assessment/preparation/prepared_blocks.h"

namespace tactooth {
namespace {

using namespace test;

constexpr double kLength = 0.02, kShare = 0.02;
const TriangleMesh kIdeal = blockWithBox(-2, 2, -1.5, 1.5, 3);  // 4 x 3 mm, 2 mm deep

ErrorPatches patchesOf(const Preparation& preparation) { return errorPatches(preparation, CutSurfaces(preparation)); }

std::string_view wallOf(const ErrorPatch& patch, const Preparation& preparation) {
    const CutSurfaces surfaces(preparation);
    return wallName(patch, DentalDirections(preparation.axis, preparation.mesialX), surfaces.isCrown).english;
}

TEST(ErrorPatch, OfTheIdealPreparationThereAreNone) {
    const ErrorPatches none = patchesOf(blockPreparation(kIdeal, kIdeal));
    EXPECT_TRUE(none.over.empty());
    EXPECT_TRUE(none.under.empty());
}

TEST(ErrorPatch, NamesTheWallAndItsVolume) {
    struct Wall {
        double left, right, back, front;  // too much on each side, mm
        std::string_view name;
        double length;  // mm
    };
    for (const Wall& wall : {Wall{0, 0.5, 0, 0, "Mesial wall", 3}, Wall{0.5, 0, 0, 0, "Distal wall", 3},
                             Wall{0, 0, 0.5, 0, "Lingual wall", 4}, Wall{0, 0, 0, 0.5, "Buccal wall", 4}}) {
        SCOPED_TRACE(wall.name);
        const Preparation wide = blockPreparation(
            blockWithBox(-2 - wall.left, 2 + wall.right, -1.5 - wall.back, 1.5 + wall.front, 3), kIdeal);
        const ErrorPatches patches = patchesOf(wide);
        ASSERT_EQ(patches.over.size(), 1U);
        EXPECT_TRUE(patches.under.empty());
        EXPECT_NEAR(patches.over[0].depth, 0.5, kLength);
        EXPECT_EQ(wallOf(patches.over[0], wide), wall.name);
        // 0.5 mm up to 0.5 mm below the top, from there less down to half of it; and strips of floor and other walls.
        const double wallOnly = wall.length * (1.5 * 0.5 + 0.25 * 0.375);
        EXPECT_GT(patches.over[0].volume, wallOnly * (1 - kShare) - 0.05);
        EXPECT_LT(patches.over[0].volume, wallOnly + 1);
    }
}

TEST(ErrorPatch, OfAFloorTooDeepIsTheFloor) {
    const Preparation deep = blockPreparation(blockWithBox(-2, 2, -1.5, 1.5, 2.5), kIdeal);
    const ErrorPatches patches = patchesOf(deep);
    ASSERT_FALSE(patches.over.empty());
    EXPECT_EQ(wallOf(patches.over[0], deep), "Floor");
    EXPECT_NEAR(patches.over[0].depth, 0.5, kLength);
    EXPECT_NEAR(patches.over[0].place.z(), 2.5, kLength);
}

TEST(ErrorPatch, OfTwoPlacesAreTwo) {
    // Too far on both sides: the floor between them is right.
    const Preparation wide = blockPreparation(blockWithBox(-2.4, 2.6, -1.5, 1.5, 3), kIdeal);
    const ErrorPatches patches = patchesOf(wide);
    ASSERT_EQ(patches.over.size(), 2U);
    EXPECT_GT(patches.over[0].volume, patches.over[1].volume);
    EXPECT_EQ(wallOf(patches.over[0], wide), "Mesial wall");
    EXPECT_EQ(wallOf(patches.over[1], wide), "Distal wall");
    EXPECT_NEAR(patches.over[1].depth, 0.4, kLength);
}

TEST(ErrorPatch, OfWhatIsLeftLiesOnTheIdealSurface) {
    const Preparation shallow = blockPreparation(blockWithBox(-2, 2, -1.5, 1.5, 3.5), kIdeal);
    const ErrorPatches patches = patchesOf(shallow);
    EXPECT_TRUE(patches.over.empty());
    ASSERT_FALSE(patches.under.empty());
    EXPECT_FALSE(patches.under[0].isOver);
    EXPECT_NEAR(patches.under[0].depth, 0.5, kLength);
    EXPECT_NEAR(patches.under[0].place.z(), 3, kLength);
}

TEST(ErrorPatch, SmallerThanTheToleranceIsFoundToo) {
    Preparation wide = blockPreparation(blockWithBox(-2, 2.1, -1.5, 1.5, 3), kIdeal);
    ASSERT_LT(0.1, wide.tolerance);
    const ErrorPatches patches = patchesOf(wide);
    ASSERT_EQ(patches.over.size(), 1U);
    EXPECT_NEAR(patches.over[0].depth, 0.1, kLength);
}

}  // namespace
}  // namespace tactooth
