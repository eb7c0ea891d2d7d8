// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "assessment/preparation/prepared_blocks.h"
#include "geometry/util/degree.h"
#include "support/shapes.h"

// Stumps of known taper, room and height.

namespace tactooth {
namespace {

using namespace test;

constexpr double kLength = 0.02, kAngle = 0.5;  // what has to be reached: mm, degrees

const TriangleMesh kCavity = blockWithBox(-2, 2, -1.5, 1.5, 3);

PreparationMeasures measured(const TriangleMesh& student, const TriangleMesh& ideal = kCavity) {
    return PreparationMeasures(blockPreparation(student, ideal));
}

/// A stump of 4 mm height and `degrees` taper on a shoulder.
TriangleMesh stump(double degrees) {
    const double in = 4 * std::tan(degrees * kDegree);
    return preparedBlock(0, Rectangle::level(-4, 4, -4, 4, 0), Rectangle::level(-4 + in, 4 - in, -4 + in, 4 - in, 4));
}

/// A pyramid on a step of this width round the whole block, 4 mm high; its end rises by `rise` from -x to +x.
TriangleMesh crownStump(double convergence, double step, double rise = 0) {
    const double side = 5 - step, in = 4 * std::tan(convergence / 2 * kDegree);
    return preparedBlock(0, Rectangle::level(-side, side, -side, side, 0),
                         Rectangle{-side + in, side - in, -side + in, side - in, 4 - rise / 2, 4 + rise / 2});
}

TEST(CrownMetrics, MeasureConvergenceAndStepOfAStump) {
    for (const double convergence : {3.0, 10.0, 22.0}) {
        SCOPED_TRACE(convergence);
        const TriangleMesh stump = crownStump(convergence, 0.15);
        const PreparationMeasures crown = measured(stump, stump);
        EXPECT_NEAR(valueOf(crown, "toc_md"), convergence, kAngle);
        EXPECT_NEAR(valueOf(crown, "toc_bl"), convergence, kAngle);
        EXPECT_NEAR(valueOf(crown, "finish_line_width"), 0.15, kLength);
        EXPECT_EQ(valueOf(crown, "undercut_area_best"), 0);
    }
}

/// A round stump of 4 mm height in a cylinder of 5 mm radius.
Preparation roundStump(double taper, double radius = 3.9) {
    constexpr int kSides = 96;
    TriangleMesh stump = cylinder(Vec3::Zero(), radius, 4, kSides);
    const auto narrower = static_cast<float>(1 - 4 * std::tan(taper * kDegree) / radius);
    for (Vec3f& vertex : stump.vertices) {
        if (vertex.z() > 1) vertex.head<2>() *= narrower;
    }
    Preparation preparation = blockPreparation(stump, stump);
    preparation.original = std::make_shared<const SurfacePart>(cylinder(Vec3::Zero(), 4.5, 5, kSides));
    return preparation;
}

TEST(CrownMetrics, MeasureTheConvergenceOfAConeInTwoWaysThatAgree) {
    for (const double taper : {1.5, 5.0, 11.0}) {
        SCOPED_TRACE(taper);
        const PreparationMeasures cone(roundStump(taper));
        EXPECT_NEAR(valueOf(cone, "toc_sections"), 2 * taper, kAngle);
        EXPECT_NEAR(valueOf(cone, "toc_cone"), 2 * taper, kAngle);
        EXPECT_LT(valueOf(cone, "toc_difference"), 1);
    }
    EXPECT_EQ(reasonOf(measured(kCavity), "toc_sections"), "no_crown_preparation");
    EXPECT_EQ(reasonOf(measured(kCavity), "toc_cone"), "no_crown_preparation");
    EXPECT_EQ(reasonOf(measured(kCavity), "toc_difference"), "no_crown_preparation");
}

/// A pyramid is no cone: a section that meets a wall at an angle sees it flatter.
TEST(CrownMetrics, TheTwoConvergencesOfAPyramidDiffer) {
    const double taper = 11;
    const PreparationMeasures pyramid = measured(crownStump(2 * taper, 0.5), crownStump(2 * taper, 0.5));
    double sections = 0;
    for (int i = 0; i < 8; ++i) {
        const double turn = std::abs(std::remainder((i + 0.5) * 22.5, 90.0)) * kDegree;
        sections += 2 * std::atan(std::tan(taper * kDegree) / std::cos(turn)) / kDegree / 8;
    }
    EXPECT_NEAR(valueOf(pyramid, "toc_sections"), sections, kAngle);
    EXPECT_NEAR(valueOf(pyramid, "toc_cone"), 2 * taper, kAngle);
    EXPECT_NEAR(valueOf(pyramid, "toc_difference"), sections - 2 * taper, 2 * kAngle);
}

TEST(CrownMetrics, MeasureTheRoomOverTheStump) {
    const PreparationMeasures flat = measured(crownStump(12, 0.5), crownStump(12, 0.5));
    EXPECT_NEAR(valueOf(flat, "occlusal_reduction_min"), 1, kLength);
    EXPECT_NEAR(valueOf(flat, "occlusal_reduction_median"), 1, kLength);
    // From 0.8 to 1.2 mm: a twentieth is less than 0.82 mm.
    const PreparationMeasures rising = measured(crownStump(12, 0.5, 0.4), crownStump(12, 0.5));
    EXPECT_NEAR(valueOf(rising, "occlusal_reduction_min"), 0.82, kLength);
    EXPECT_NEAR(valueOf(rising, "occlusal_reduction_median"), 1, kLength);
    EXPECT_EQ(reasonOf(measured(kCavity), "occlusal_reduction_min"), "no_crown_preparation");
}

TEST(CrownMetrics, MeasureTheHeightAboveTheGum) {
    const TriangleMesh stump = crownStump(12, 0.5);
    EXPECT_EQ(reasonOf(measured(stump, stump), "finish_line_height"), "no_gum_known");
    EXPECT_EQ(reasonOf(measured(kCavity), "finish_line_height"), "no_crown_preparation");
    for (const double height : {-0.3, 0.5, 1.2}) {
        Preparation preparation = blockPreparation(stump, stump);
        for (const double side : {-1.0, 1.0}) {  // a gum of 2 mm round the block, 0.05 mm beside it
            const double near = 5.05 * side, far = 7.05 * side;
            preparation.gums.push_back(std::make_shared<const SurfacePart>(
                box(Vec3(std::min(near, far), -8, -5), Vec3(std::max(near, far), 8, -height))));
            preparation.gums.push_back(std::make_shared<const SurfacePart>(
                box(Vec3(-8, std::min(near, far), -5), Vec3(8, std::max(near, far), -height))));
        }
        EXPECT_NEAR(valueOf(PreparationMeasures(preparation), "finish_line_height"), height, kLength);
    }
}

TEST(CrownMetrics, MeasureTheTaperOfAStump) {
    for (const double taper : {3.0, 10.0, 22.0}) {
        const PreparationMeasures crown = measured(stump(taper), stump(6));
        EXPECT_NEAR(valueOf(crown, "toc_md"), 2 * taper, kAngle);
        EXPECT_NEAR(valueOf(crown, "toc_bl"), 2 * taper, kAngle);
        EXPECT_NEAR(valueOf(crown, "wall_angle_m"), taper, kAngle);
        EXPECT_EQ(reasonOf(crown, "isthmus_min"), "no_cavity");
    }
    EXPECT_EQ(reasonOf(measured(kCavity), "toc_md"), "no_crown_preparation");
}

}  // namespace
}  // namespace tactooth
