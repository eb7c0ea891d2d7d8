// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// The metrics on surfaces as a scanner gives them: another meshing, and noise of 13 um RMS (PMC5549906 has 5 to 13).
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "assessment/preparation/prepared_blocks.h"
#include "geometry/mesh/subdivide.h"
#include "geometry/util/degree.h"

namespace tactooth {
namespace {

using namespace test;

constexpr double kLength = 0.05, kAngle = 1, kShare = 0.02;  // what has to be reached: mm, degrees, of a volume
constexpr double kNoise = 0.013;                             // mm
constexpr int kLevels = 5;                                   // 1,024 triangles for each: edges of 0.1 to 0.3 mm

/// The surface as a scan.
TriangleMesh scanned(const TriangleMesh& exact, unsigned seed) {
    TriangleMesh scan = subdivided(exact, kLevels);
    std::mt19937 random(seed);
    std::normal_distribution<float> error(0, kNoise / std::sqrt(3.0F));
    for (Vec3f& vertex : scan.vertices) vertex += Vec3f(error(random), error(random), error(random));
    return scan;
}

class ScannedBlock : public testing::TestWithParam<unsigned> {
protected:
    [[nodiscard]] static PreparationMeasures measured(const TriangleMesh& student) {
        return PreparationMeasures(blockPreparation(scanned(student, GetParam()), ideal()));
    }
    [[nodiscard]] static TriangleMesh ideal() { return blockWithBox(-2, 2, -1.5, 1.5, 3); }  // 4 x 3 mm, 2 mm deep
};

TEST_P(ScannedBlock, TooDeep) {
    const PreparationMeasures deep = measured(blockWithBox(-2, 2, -1.5, 1.5, 2.7));
    EXPECT_NEAR(valueOf(deep, "over_max"), 0.3, kLength);
    EXPECT_NEAR(valueOf(deep, "over_volume"), 3.6, kShare * 24);
    EXPECT_NEAR(valueOf(deep, "dice"), 2 * 24 / (24 + 27.6), kShare);
    EXPECT_NEAR(valueOf(deep, "floor_depth_median"), 2.3, kLength);
    EXPECT_NEAR(valueOf(deep, "floor_tilt"), 0, kAngle);
    EXPECT_NEAR(valueOf(deep, "floor_flatness"), 0, kLength);
}

TEST_P(ScannedBlock, TooWideOnOneSide) {
    const PreparationMeasures wide = measured(blockWithBox(-2, 2.2, -1.5, 1.5, 3));
    EXPECT_NEAR(valueOf(wide, "over_max"), 0.2, kLength);
    EXPECT_NEAR(valueOf(wide, "over_volume"), 1.2, kShare * 24);
    EXPECT_NEAR(valueOf(wide, "extent_md"), 4.2, 2 * kLength);
    EXPECT_NEAR(valueOf(wide, "ridge_min_m"), 2.8, kLength);
}

TEST_P(ScannedBlock, AWallFiveDegreesOff) {
    const PreparationMeasures leaning = measured(blockWithCavityTo(
        Rectangle::level(-2, 2 + 2 * std::tan(5 * kDegree), -1.5, 1.5, 5), Rectangle::level(-2, 2, -1.5, 1.5, 3)));
    EXPECT_NEAR(valueOf(leaning, "wall_angle_m"), -5, kAngle);
    EXPECT_NEAR(valueOf(leaning, "wall_angle_d"), 0, kAngle);
    EXPECT_NEAR(valueOf(leaning, "wall_angle_b"), 0, kAngle);
}

TEST_P(ScannedBlock, ATiltedFloor) {
    const double rise = 2 * std::tan(4 * kDegree);
    const PreparationMeasures tilted = measured(
        blockWithCavityTo(Rectangle::level(-2, 2, -1.5, 1.5, 5), Rectangle{-2, 2, -1.5, 1.5, 3 - rise, 3 + rise}));
    EXPECT_NEAR(valueOf(tilted, "floor_tilt"), 4, kAngle);
    EXPECT_NEAR(valueOf(tilted, "floor_depth_median"), 2, kLength);
}

TEST_P(ScannedBlock, StumpsOfThreeTapers) {
    for (const double taper : {1.5, 5.0, 11.0}) {
        const double in = 4 * std::tan(taper * kDegree);
        const TriangleMesh stump =
            preparedBlock(0, Rectangle::level(-4, 4, -4, 4, 0), Rectangle::level(-4 + in, 4 - in, -4 + in, 4 - in, 4));
        const PreparationMeasures measures(blockPreparation(scanned(stump, GetParam()), stump));
        EXPECT_NEAR(valueOf(measures, "toc_md"), 2 * taper, kAngle);
        EXPECT_NEAR(valueOf(measures, "toc_bl"), 2 * taper, kAngle);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ScannedBlock, testing::Values(1, 2, 3));

}  // namespace
}  // namespace tactooth
