// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// What the rubric of each built-in exercise makes of hands of three levels: real contact, real cutting, simulated time.
// TACTOOTH_HANDS=20 takes 20 hands of each level, beginners too, at all exercises; with 1 that is nine minutes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <optional>

#include "assessment/exercise_scene.h"
#include "assessment/ideal_shape.h"
#include "assessment/rubric/exercise_rubric.h"
#include "assessment/study/hand_trial.h"

namespace tactooth {
namespace {

using test::ExerciseScene;

/// Of each level, at each exercise. None: one hand at a few exercises, which takes a minute.
std::optional<int> wantedHands() {
    const char* wanted = std::getenv("TACTOOTH_HANDS");
    return wanted != nullptr ? std::optional(std::max(1, std::atoi(wanted))) : std::nullopt;
}

int handsOfEach() { return wantedHands().value_or(1); }

/// Those whose ideal says how the bur moves: not the crowns.
std::vector<std::shared_ptr<const Exercise>> exercisesWithPaths() {
    constexpr std::array kFew = {"pit-46", "line-11", "class-5-34"};
    std::vector<std::shared_ptr<const Exercise>> chosen;
    for (const auto& exercise : exercises()) {
        const auto* plan = std::get_if<PreparationPlan>(&exercise->ideal);
        if (plan == nullptr || plan->crown) continue;
        if (wantedHands() || std::ranges::find(kFew, exercise->id) != kFew.end()) chosen.push_back(exercise);
    }
    return chosen;
}

class EachExercise : public ::testing::TestWithParam<std::shared_ptr<const Exercise>> {
protected:
    [[nodiscard]] Expected<StudyScene> scene() const {
        const ExerciseScene& scene = ExerciseScene::of(exercise_);
        if (!scene.ideal) return Unexpected{scene.ideal.error()};
        return studyScene(exercise_, scene.preparation(exercise_));
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
    const auto study = scene();
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

INSTANTIATE_TEST_SUITE_P(Exercises, EachExercise, ::testing::ValuesIn(exercisesWithPaths()), idOfExercise);

}  // namespace
}  // namespace tactooth
