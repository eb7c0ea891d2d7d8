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
