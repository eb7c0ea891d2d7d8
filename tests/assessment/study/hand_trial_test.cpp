// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Synthetic hands at a built-in exercise: real contact, real cutting, in simulated time.
#include "assessment/study/hand_trial.h"

#include <gtest/gtest.h>

#include <optional>

#include "assessment/exercise_scene.h"
#include "assessment/rubric/rubric_file.h"

namespace tactooth {
namespace {

class HandTrialTest : public testing::Test {
protected:
    HandTrialTest() {
        const Exercise& exercise = *builtinExercise("line-11");
        auto made = studyScene(exercise, test::ExerciseScene::of(exercise).preparation(exercise));
        if (made) scene_.emplace(std::move(*made));
    }
    void SetUp() override { ASSERT_TRUE(scene_); }
    [[nodiscard]] HandTrial play(const HandHabits& habits, std::uint64_t seed = 1) const {
        return playHand(*scene_, uncutModel(*scene_), habits, seed);
    }
    [[nodiscard]] static double value(const HandTrial& trial, std::string_view id) {
        for (const MetricResult& each : trial.metrics) {
            if (each.metric->id == id) return each.measured.value.value_or(-1);
        }
        return -2;
    }

    std::optional<StudyScene> scene_;
};

TEST_F(HandTrialTest, AnExpertsHandMakesGoodWork) {
    const HandTrial trial = play(usualHabits(HandLevel::Expert));
    EXPECT_TRUE(trial.isFinished);
    EXPECT_GT(value(trial, "cleared_share"), 0.85);
    EXPECT_LT(value(trial, "over_max"), 0.2);
    EXPECT_LT(value(trial, "force_p95"), 1.2);
    EXPECT_GT(value(trial, "drilling_time"), 1);
}

TEST_F(HandTrialTest, TheSameHandDoesTheSame) {
    const HandHabits habits = usualHabits(HandLevel::Student);
    const HandTrial first = play(habits), again = play(habits), other = play(habits, 2);
    EXPECT_EQ(first.toothHash, again.toothHash);
    EXPECT_NE(first.toothHash, other.toothHash);
    for (std::size_t i = 0; i < first.metrics.size(); ++i)
        EXPECT_EQ(first.metrics[i].measured.value, again.metrics[i].measured.value) << first.metrics[i].metric->id;
}

TEST_F(HandTrialTest, AHandThatGoesTooDeepIsMeasuredAsThatDeep) {
    HandHabits habits = usualHabits(HandLevel::Expert);
    const double before = value(play(habits), "over_max");
    habits.deeper = 0.3;
    EXPECT_NEAR(value(play(habits), "over_max") - before, 0.3, 0.12);
}

}  // namespace
}  // namespace tactooth
