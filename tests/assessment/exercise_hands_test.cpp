// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// What the rubric of each built-in exercise makes of hands of three levels: real contact, real cutting, simulated time.
// TACTOOTH_HANDS=20 takes 20 hands of each level at all exercises.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
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

std::size_t handsOfEach() { return static_cast<std::size_t>(wantedHands().value_or(1)); }

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
    void SetUp() override {
        const ExerciseScene& scene = ExerciseScene::of(exercise_);
        ASSERT_TRUE(scene.ideal) << scene.ideal.error().message();
        auto made = studyScene(exercise_, scene.preparation(exercise_));
        ASSERT_TRUE(made) << made.error().message();
        scene_.emplace(std::move(*made));
        auto rubric = rubricOf(exercise_, "");
        ASSERT_TRUE(rubric) << rubric.error().message();
        rubric_ = std::move(*rubric);
    }

    /// Prints it with what it lost.
    double markOfHand(std::string_view name, const HandHabits& habits, std::uint64_t seed) const {
        const HandTrial trial = playHand(*scene_, uncutModel(*scene_), habits, seed);
        EXPECT_TRUE(trial.isFinished) << name;
        const Mark mark = markOf(rubric_, trial.metrics);
        std::cout << exercise_.id << ", " << name << " " << seed << ": " << mark.value.value_or(-1) << " (";
        for (const CriterionScore& each : mark.criteria) {
            if (each.lost < 1) continue;
            std::cout << " " << each.criterion->metric->id << " " << *each.measured.value << ": -" << each.lost << ";";
        }
        for (const Criterion* each : mark.limitedBy) std::cout << " limited by " << each->metric->id;
        std::cout << " )" << std::endl;
        return mark.value.value_or(-1);
    }

    /// By seed.
    [[nodiscard]] std::vector<double> marksOf(std::string_view name, HandLevel level) const {
        std::vector<double> marks;
        for (std::uint64_t seed = 1; seed <= handsOfEach(); ++seed)
            marks.push_back(markOfHand(name, habitsOfHand(level, seed), seed));
        return marks;
    }

    const Exercise& exercise_ = *GetParam();
    std::optional<StudyScene> scene_;
    Rubric rubric_;
};

TEST_P(EachExercise, PutsExpertsBeforeStudentsAndThoseBeforeBeginners) {
    const std::vector<double> expert = marksOf("expert", HandLevel::Expert);
    const std::vector<double> student = marksOf("student", HandLevel::Student);
    const std::vector<double> beginner = marksOf("beginner", HandLevel::Beginner);
    EXPECT_GE(std::ranges::min(expert), 90);
    EXPECT_GE(std::ranges::min(student), 60);
    EXPECT_LE(std::ranges::max(student), 85);
    EXPECT_GT(std::ranges::min(expert), std::ranges::max(student));
    EXPECT_GT(std::ranges::min(student), std::ranges::max(beginner));
    EXPECT_LE(std::ranges::max(beginner), 85);
    EXPECT_GT(std::ranges::min(expert), std::ranges::max(beginner) + 5);
}

/// However neat it is.
TEST_P(EachExercise, FailsWhoStopsHalfWay) {
    HandHabits habits = usualHabits(HandLevel::Expert);
    habits.undone = 0.5;
    EXPECT_LT(markOfHand("expert who stops half way", habits, 1), rubric_.passMark);
}

std::string idOfExercise(const ::testing::TestParamInfo<std::shared_ptr<const Exercise>>& one) {
    std::string name = one.param->id;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Exercises, EachExercise, ::testing::ValuesIn(exercisesWithPaths()), idOfExercise);

}  // namespace
}  // namespace tactooth
