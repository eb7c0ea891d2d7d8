// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/crown/crown_form.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "assessment/preparation/preparation_metrics.h"
#include "collision/bvh/closest_point.h"
#include "geometry/mesh/mesh_report.h"
#include "support/materials.h"

namespace tactooth {
namespace {

/// The exercise on the tooth of another patient.
Exercise ofPatient(const char* id, std::uint32_t seed) {
    Exercise exercise = *builtinExercise(id);
    std::get<ToothRequest>(exercise.tooth).seed = seed;
    return exercise;
}

double valueOf(const std::vector<MetricResult>& results, std::string_view id) {
    const auto found = std::ranges::find(results, id, [](const MetricResult& each) { return each.metric->id; });
    EXPECT_TRUE(found->measured.value) << id;
    return found->measured.value.value_or(-1e9);
}

class CrownOfAnyPatient : public testing::TestWithParam<std::pair<const char*, std::uint32_t>> {};

TEST_P(CrownOfAnyPatient, HasTheFinishLineWallsAndRoomOfItsPlan) {
    const Exercise exercise = ofPatient(GetParam().first, GetParam().second);
    const auto tooth = *exerciseTooth(exercise);
    const auto& plan = std::get<PreparationPlan>(exercise.ideal);
    const Expected<TriangleMesh> ideal = idealShape(exercise, tooth);
    ASSERT_TRUE(ideal) << ideal.error().message();
    ASSERT_TRUE(reportOn(*ideal).watertight());
    Preparation preparation;
    preparation.original = tooth->ownOuter();
    preparation.prepared = preparation.ideal = std::make_shared<const SurfacePart>(*ideal);
    preparation.mesialX = tooth->toothContext().mesialX;
    const std::vector<MetricResult> results = measureAll(PreparationMeasures(preparation));
    EXPECT_NEAR(valueOf(results, "toc_md"), 2 * plan.crown->taper, 1);
    // A round end makes a wall from 30 degrees on.
    const double arc = plan.crown->tipRadius * (1 - std::cos(0.5236));
    EXPECT_NEAR(valueOf(results, "finish_line_width"), plan.crown->width - arc, 0.1);
    EXPECT_LT(valueOf(results, "finish_line_roughness"), 0.03);
    EXPECT_LT(valueOf(results, "undercut_area"), 0.2);
    EXPECT_NEAR(valueOf(results, "occlusal_reduction_median"), (plan.crown->occlusal + plan.crown->functional) / 2,
                0.5);
}

TEST_P(CrownOfAnyPatient, BeginsAboveTheEndOfTheEnamel) {
    const Exercise exercise = ofPatient(GetParam().first, GetParam().second);
    const auto tooth = *exerciseTooth(exercise);
    const auto& plan = std::get<PreparationPlan>(exercise.ideal);
    const auto form = CrownForm::make(plan, *tooth, tooth->ownOuter());
    ASSERT_TRUE(form) << form.error().message();
    const SurfacePart* dentin = nullptr;
    for (const LayeredTooth::Layer& layer : tooth->layers()) {
        if (layer.material == test::kDentin) dentin = layer.part.get();
    }
    int enamel = 0, root = 0;
    const auto& points = form->finishLine().points();
    for (const Vec3& place : points) {
        // On the tooth; with enamel there, and none a little deeper than the height below.
        EXPECT_LT(closestPoint(*tooth->ownOuter(), place)->distance, 1e-3);
        enamel += closestPoint(*dentin, place)->distance > 0.05;
        const Vec3 below = place - (plan.crown->proximalHeight + 0.6) * plan.outward;
        const Vec3 surface = closestPoint(*tooth->ownOuter(), below)->point;
        root += closestPoint(*dentin, surface)->distance < 0.05;
    }
    EXPECT_GT(enamel, static_cast<int>(0.95 * static_cast<double>(points.size())));
    EXPECT_GT(root, static_cast<int>(0.9 * static_cast<double>(points.size())));
}

INSTANTIATE_TEST_SUITE_P(Patients, CrownOfAnyPatient,
                         testing::Values(std::pair("crown-46", 0U), std::pair("crown-46", 5U)));

TEST(CrownForm, OfAToothWithoutLayersNeedsItsCervicalLine) {
    const Exercise exercise = ofPatient("crown-46", 0);
    const auto built = *exerciseTooth(exercise);
    const auto bare = LayeredTooth::make(built->ownOuter()->mesh(), {});
    ASSERT_TRUE(bare);
    PreparationPlan plan = std::get<PreparationPlan>(exercise.ideal);
    const auto none = CrownForm::make(plan, *bare, bare->ownOuter());
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message().find("cervical"), std::string::npos);
    plan.crown->cervical = 0.4;
    const auto given = CrownForm::make(plan, *bare, bare->ownOuter());
    ASSERT_TRUE(given);
    EXPECT_NEAR(given->finishLine().lowest(), 0.4 + plan.crown->height, 0.05);
    plan.crown->cervical = 60;
    EXPECT_FALSE(CrownForm::make(plan, *bare, bare->ownOuter()));
}

}  // namespace
}  // namespace tactooth
