// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/icons/exercise_picture.h"

#include <gtest/gtest.h>

#include "app/common/offscreen_application.h"
#include "assessment/exercise.h"

namespace tactooth {
namespace {

TEST(ExercisePicture, EachBuiltInExerciseHasOne) {
    const OffscreenApplication application;
    for (const auto& exercise : exercises()) {
        const QPixmap picture = exercisePicture(*exercise);
        ASSERT_FALSE(picture.isNull()) << exercise->id << ": run 'tactooth gallery --exercises'";
        EXPECT_EQ(picture.size(), QSize(360, 240)) << exercise->id;
    }
}

TEST(ExercisePicture, OneOfTheUsersOwnHasNone) {
    const OffscreenApplication application;
    Exercise own = *exercises().front();
    own.id.clear();
    EXPECT_TRUE(exercisePicture(own).isNull());
}

}  // namespace
}  // namespace tactooth
