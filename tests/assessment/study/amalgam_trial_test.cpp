// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The material that the exercise amalgam-46 brings: felt, cut, counted, saved, replayed and scored.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/exercise_scene.h"
#include "assessment/practice_report.h"
#include "assessment/rubric/exercise_rubric.h"
#include "assessment/study/hand_trial.h"
#include "session/audio/tick_sound.h"
#include "session/recording/session_recorder.h"
#include "session/recording/session_replay.h"
#include "session/simulation/tooth_file.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

class AmalgamTrial : public testing::Test {
protected:
    AmalgamTrial() {
        auto made = studyScene(exercise_, test::ExerciseScene::of(exercise_).preparation(exercise_));
        if (made) scene_.emplace(std::move(*made));
    }
    void SetUp() override { ASSERT_TRUE(scene_ && amalgam_); }

    /// The numbers are those of the exercise, whoever asks for them.
    void expectAmalgam(const MaterialRegistry& materials) const {
        const auto found = materials.find("amalgam");
        ASSERT_TRUE(found);
        EXPECT_EQ(materials[*found].numbers, (*exercise_.materials)[*amalgam_].numbers);
        EXPECT_EQ(materials[*found].titleJa, "アマルガム");
    }
    [[nodiscard]] double volume(const MaterialVolumes& removed) const {
        return removed[static_cast<std::size_t>(*amalgam_)];
    }

    const Exercise& exercise_ = *builtinExercise("amalgam-46");
    std::optional<MaterialId> amalgam_ = exercise_.materials->find("amalgam");
    std::optional<StudyScene> scene_;
};

TEST_F(AmalgamTrial, ItIsNoMaterialOfOtherTeeth) {
    EXPECT_FALSE(builtinMaterials().find("amalgam"));
    EXPECT_EQ(&builtinExercise("filling-46")->materials->operator[](MaterialId{}), &builtinMaterials()[MaterialId{}]);
    EXPECT_EQ(&scene_->preparation.tooth->materials(), exercise_.materials);
    // The tip of the bur goes along the floor of the filling, and past its border.
    std::size_t inFilling = 0, places = 0;
    for (const auto& path : scene_->task.paths) {
        for (const Vec3& place : path) {
            inFilling += scene_->preparation.tooth->materialAt(place + 0.2 * scene_->task.outward) == *amalgam_ ? 1 : 0;
            ++places;
        }
    }
    EXPECT_GT(2 * inFilling, places);
}

TEST_F(AmalgamTrial, IsTouchedCutCountedSavedAndReplayed) {
    const test::TemporaryFolder folder;
    const auto model = uncutModel(*scene_);
    auto recorder = SessionRecorder::create(folder / "s.ttsession", *model, "amalgam");
    ASSERT_TRUE(recorder) << recorder.error().message();
    HandHabits habits = usualHabits(HandLevel::Expert);
    habits.undone = 0.6;
    std::ignore = playHand(*scene_, model, habits, 1, [&](const SessionEvent& event) { (*recorder)->append(event); });
    ASSERT_TRUE((*recorder)->close(model->hash()));
    const double removed = volume(model->removed());
    EXPECT_GT(removed, 1);

    PracticeReport report;
    report.removed = model->removed();
    report.materials = &model->tooth().materials();
    EXPECT_THAT(practiceReportCsv(report), HasSubstr("\namalgam removed,"));

    ASSERT_TRUE(saveTooth(*model, {}, folder / "half.tactooth"));
    const auto opened = openTooth(folder / "half.tactooth");
    ASSERT_TRUE(opened) << opened.error().message();
    EXPECT_TRUE(opened->importNotes.empty());
    expectAmalgam(opened->piece->tooth().materials());
    EXPECT_EQ(opened->piece->hash(), model->hash());
    EXPECT_EQ(volume(opened->piece->removed()), removed);

    const auto recording = SessionRecording::open(folder / "s.ttsession");
    ASSERT_TRUE(recording) << recording.error().message();
    auto replay = SessionReplay::start(*recording);
    ASSERT_TRUE(replay) << replay.error().message();
    expectAmalgam(replay->model().tooth().materials());
    const MaterialTable table(replay->model().tooth().materials());
    int felt = 0;
    const auto played = replay->playUntil({}, [&](double, const Tick& tick) {
        if (tick.force.stiffness <= 0 || tick.contact.material != *amalgam_) return;
        if (++felt > 1) return;
        EXPECT_EQ(tick.force.stiffness, table[*amalgam_].stiffness);
        EXPECT_EQ(soundOf(tick, spindlePresets().front(), table).material.bandCentreHz, table[*amalgam_].soundCentre);
    });
    ASSERT_TRUE(played) << played.error().message();
    EXPECT_GT(felt, 100);
    EXPECT_FALSE(replay->differsAt());
    EXPECT_EQ(replay->model().hash(), model->hash());
    EXPECT_EQ(volume(replay->model().removed()), removed);
}

TEST_F(AmalgamTrial, HalfOfItIsScoredAsHalf) {
    HandHabits habits = usualHabits(HandLevel::Expert);
    habits.undone = 0.6;
    const HandTrial half = playHand(*scene_, uncutModel(*scene_), habits, 1);
    const auto rubric = rubricOf(exercise_, "");
    ASSERT_TRUE(rubric) << rubric.error().message();
    const Mark mark = markOf(*rubric, half.metrics);
    EXPECT_GT(mark.value.value_or(-1), 0);
    EXPECT_FALSE(mark.passes);
}

}  // namespace
}  // namespace tactooth
