// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// What the rubric of each built-in exercise makes of hands of three levels: real contact, real cutting, simulated time.
// It takes minutes, so it runs where TACTOOTH_HANDS says how many hands of each level work; 2 and more: beginners, too.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>

#include "assessment/exercise_scene.h"
#include "assessment/ideal_shape.h"
#include "assessment/rubric/exercise_rubric.h"
#include "assessment/study/hand_trial.h"
#include "support/materials.h"

namespace tactooth {
namespace {

using test::ExerciseScene;

int handsOfEach() {
    const char* wanted = std::getenv("TACTOOTH_HANDS");
    return wanted != nullptr ? std::atoi(wanted) : 0;
}

class EachExercise : public ::testing::TestWithParam<std::shared_ptr<const Exercise>> {
protected:
    [[nodiscard]] Expected<StudyScene> scene() const {
        const ExerciseScene& scene = ExerciseScene::of(exercise_);
        if (!scene.ideal) return Unexpected{scene.ideal.error()};
        Preparation preparation;
        preparation.tooth = scene.tooth;
        preparation.original = scene.tooth->ownOuter();
        preparation.ideal = std::make_shared<const SurfacePart>(*scene.ideal);
        preparation.axis = std::get<PreparationPlan>(exercise_.ideal).outward;
        preparation.mesialX = scene.tooth->toothContext().mesialX;
        preparation.forbidden = exercise_.forbidden;
        preparation.gums = exerciseGums(exercise_);
        for (const LayeredTooth::Layer& layer : scene.tooth->layers()) {
            if (layer.material == test::kPulp) preparation.pulps.push_back(layer.part);
        }
        return studyScene(exercise_, std::move(preparation));
    }
    const Exercise& exercise_ = *GetParam();
};

/// The marks of some hands of one level, best first.
std::vector<double> marksOf(const StudyScene& scene, const Rubric& rubric, HandLevel level) {
    std::vector<double> marks;
    for (int hand = 1; hand <= handsOfEach(); ++hand) {
        const auto seed = static_cast<std::uint64_t>(hand);
        const HandTrial trial = playHand(scene, uncutModel(scene), habitsOfHand(level, seed), seed);
        EXPECT_TRUE(trial.isFinished);
        marks.push_back(markOf(rubric, trial.metrics).value.value_or(-1));
        std::cout << "  " << marks.back();
    }
    std::ranges::sort(marks, std::greater());
    return marks;
}

TEST_P(EachExercise, PutsAnExpertsHandFirst) {
    if (handsOfEach() < 1) GTEST_SKIP() << "TACTOOTH_HANDS is not set";
    const auto study = scene();
    if (!study && std::get<PreparationPlan>(exercise_.ideal).crown) GTEST_SKIP() << study.error().message();
    ASSERT_TRUE(study) << study.error().message();
    const auto rubric = rubricOf(exercise_, "");
    ASSERT_TRUE(rubric) << rubric.error().message();
    std::cout << exercise_.id << ": expert";
    const std::vector<double> expert = marksOf(*study, *rubric, HandLevel::Expert);
    std::cout << ", student";
    const std::vector<double> student = marksOf(*study, *rubric, HandLevel::Student);
    std::cout << std::endl;
    EXPECT_GE(expert.back(), 90);
    EXPECT_GE(student.back(), 60);
    // A student's hand goes a little deeper: where the floor is all, as in a pit, that is no worse.
    EXPECT_GT(expert.back(), student.front() - 5);
    if (handsOfEach() < 2) return;  // the bad ones take as long
    std::cout << "  beginner";
    const std::vector<double> beginner = marksOf(*study, *rubric, HandLevel::Beginner);
    std::cout << std::endl;
    EXPECT_LE(beginner.front(), 85);
    EXPECT_GT(expert.back(), beginner.front() + 5);
    EXPECT_GT(student.back(), beginner.front());
}

std::string idOfExercise(const ::testing::TestParamInfo<std::shared_ptr<const Exercise>>& one) {
    std::string name = one.param->id;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Exercises, EachExercise, ::testing::ValuesIn(exercises().begin(), exercises().end()),
                         idOfExercise);

}  // namespace
}  // namespace tactooth
