// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// What the rubric of each built-in exercise makes of work that is known to be good or bad.
#include <gtest/gtest.h>

#include <algorithm>

#include "assessment/exercise_scene.h"
#include "assessment/rubric/rubric_file.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using test::ExerciseScene;

class EachRubric : public ::testing::TestWithParam<std::shared_ptr<const Exercise>> {
protected:
    void SetUp() override {
        ASSERT_TRUE(scene_.ideal) << scene_.ideal.error().message();
        const auto found = findRubric(exercise_.rubric.empty() ? std::string(kUsualRubric) : exercise_.rubric);
        ASSERT_TRUE(found) << found.error().message();
        rubric_ = *found;
    }

    [[nodiscard]] std::vector<MetricResult> measure(const TriangleMesh& work) const {
        Preparation preparation;
        preparation.original = scene_.tooth->ownOuter();
        preparation.prepared = std::make_shared<const SurfacePart>(work);
        preparation.ideal = std::make_shared<const SurfacePart>(*scene_.ideal);
        preparation.axis = std::get<PreparationPlan>(exercise_.ideal).outward;
        preparation.mesialX = scene_.tooth->toothContext().mesialX;
        for (const LayeredTooth::Layer& layer : scene_.tooth->layers()) {
            if (layer.material == test::kPulp) preparation.pulps.push_back(layer.part);
        }
        return measureAll(PreparationMeasures(preparation));
    }

    const Exercise& exercise_ = *GetParam();
    const ExerciseScene& scene_ = ExerciseScene::of(exercise_);
    Rubric rubric_;
};

TEST_P(EachRubric, PassesAnExpertAndFailsWhoOpensThePulp) {
    std::vector<MetricResult> expert = measure(*scene_.ideal);
    const Mark mark = markOf(rubric_, expert);
    for (const CriterionScore& each : mark.criteria) {
        if (each.lost > 0.5)
            std::printf("  %s %s: %.2f costs %.1f\n", exercise_.id.c_str(), each.criterion->title.c_str(),
                        each.measured.value.value_or(-1), each.lost);
    }
    std::printf("  %s: %.1f\n", exercise_.id.c_str(), mark.value.value_or(-1));
    EXPECT_GE(mark.value.value_or(-1), 90);
    EXPECT_TRUE(mark.passes);
    const auto pulp = std::ranges::find(expert, std::string_view("pulp_open"),
                                        [](const MetricResult& each) { return each.metric->id; });
    ASSERT_NE(pulp, expert.end());
    EXPECT_EQ(pulp->measured.value, exercise_.opensPulp() ? 1 : 0);
    pulp->measured = Measured::of(exercise_.opensPulp() ? 0 : 1);
    EXPECT_FALSE(markOf(rubric_, expert).passes);
}

TEST_P(EachRubric, GivesNothingForNothing) {
    const Mark mark = markOf(rubric_, measure(scene_.tooth->ownOuter()->mesh()));
    EXPECT_EQ(mark.value.value_or(-1), 0);
}

TEST_P(EachRubric, FailsWhoRemovesEverything) {
    const Vec3 root = scene_.tooth->ownBox().min() + Vec3(0, 0, 2);
    const Vec3 middle(0, 0, root.z());
    const Mark mark = markOf(rubric_, measure(test::box(middle - Vec3::Constant(0.2), middle + Vec3::Constant(0.2))));
    EXPECT_FALSE(mark.passes);
}

std::string idOfRubric(const ::testing::TestParamInfo<std::shared_ptr<const Exercise>>& one) {
    std::string name = one.param->id;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Exercises, EachRubric, ::testing::ValuesIn(exercises().begin(), exercises().end()),
                         idOfRubric);

}  // namespace
}  // namespace tactooth
