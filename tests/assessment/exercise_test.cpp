// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/exercise.h"

#include <gtest/gtest.h>

#include "assessment/cavity_metrics.h"
#include "collision/bvh/closest_point.h"
#include "geometry/mesh/mesh_report.h"
#include "instruments/bur_catalogue.h"
#include "support/materials.h"

namespace tactooth {
namespace {

class EachExercise : public ::testing::TestWithParam<std::shared_ptr<const Exercise>> {
protected:
    std::shared_ptr<const LayeredTooth> tooth_ = *exerciseTooth(*GetParam());
};

TEST_P(EachExercise, HasAClosedIdealShapeThatABeginnerCouldCut) {
    const auto ideal = idealShape(*GetParam(), tooth_);
    ASSERT_TRUE(ideal) << ideal.error().message();
    const MeshReport report = reportOn(*ideal);
    ASSERT_TRUE(report.watertight());
    const auto target = std::make_shared<const SurfacePart>(*ideal);
    CavityMetrics metrics(target, *tooth_->outer());
    Surface whole;
    whole.base = tooth_->outer();
    const double volume = metrics.of(whole, 0).planned;
    EXPECT_GT(volume, 0.5);
    EXPECT_LT(volume, 30);
    EXPECT_NEAR(volume, *reportOn(tooth_->outer()->mesh()).volume() - *report.volume(), 0.03 * volume);
}

TEST_P(EachExercise, LeavesThePulpCovered) {
    const auto ideal = idealShape(*GetParam(), tooth_);
    ASSERT_TRUE(ideal);
    const SurfacePart target(*ideal);
    constexpr double kMinDentin = 0.5;  // mm
    for (const LayeredTooth::Layer& layer : tooth_->layers()) {
        if (layer.material != test::kPulp) continue;
        for (const Vec3f& vertex : layer.part->mesh().vertices) {
            ASSERT_LT(signedDistance(target, vertex.cast<double>()), -kMinDentin);
        }
    }
}

TEST_P(EachExercise, TakesABurOfTheCatalogueAndASoundTooth) {
    EXPECT_TRUE(findBur(std::get<std::string>(GetParam()->bur)));
    for (const LayeredTooth::Layer& layer : tooth_->layers()) EXPECT_NE(layer.material, test::kCaries);
}

INSTANTIATE_TEST_SUITE_P(Exercises, EachExercise, ::testing::ValuesIn(exercises().begin(), exercises().end()),
                         [](const auto& one) { return "Number" + std::to_string(one.index + 1); });

}  // namespace
}  // namespace tactooth
