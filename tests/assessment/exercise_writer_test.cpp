// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/exercise_writer.h"

#include <gmock/gmock.h>

#include "assessment/exercise_file.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

Expected<Exercise> readBack(const Exercise& exercise, const std::filesystem::path& folder = {}) {
    const Expected<std::string> text = exerciseText(exercise, folder);
    if (!text) return Unexpected{text.error()};
    return parseExercise(*text, "written.toml", folder);
}

TEST(ExerciseWriter, WritesEachBuiltInExerciseAsItIsRead) {
    ASSERT_FALSE(exercises().empty());
    for (const auto& builtin : exercises()) {
        const Expected<Exercise> read = readBack(*builtin);
        ASSERT_TRUE(read) << read.error().message();
        Exercise expected = *builtin;
        expected.id.clear();
        EXPECT_EQ(*read, expected) << builtin->id;
    }
}

/// All that the editor can make, and no built-in exercise has.
Exercise drawn() {
    Exercise exercise = *builtinExercise("class-2-36-do");
    exercise.id.clear();
    exercise.name = "Own \"quoted\" name \\ 課題";
    exercise.japanese = {};
    exercise.level = ExerciseLevel::Usual;
    exercise.tolerance = 0.1 + 0.2;
    exercise.onlyTheseBurs = true;
    exercise.instruments = {HandpieceKind::Turbine, HandpieceKind::LowSpeed, HandInstrument::Excavator};
    exercise.inMouth = false;
    std::get<ToothRequest>(exercise.tooth).seed = 5;
    std::get<ToothRequest>(exercise.tooth).lesion = Lesion{.site = LesionSite::Usual,
                                                           .width = 2.1,
                                                           .depth = 1.7,
                                                           .place = Vec3(1.0 / 3, -0.2, 6.1),
                                                           .spread = {Vec3(0.1 + 0.2, 0, 6), Vec3(-1, 0.7, 6)}};
    auto& plan = std::get<PreparationPlan>(exercise.ideal);
    plan.fissure.reset();
    plan.stopsDevice = true;
    plan.outline = {.corners = {{-2, -1, 6}, {4, -1, 6.3}, {4, 1.0 / 3, 6}, {-2, 1, 6}},
                    .taperDegrees = 3.5,
                    .burRadius = 0.4,
                    .burLength = 2.7};
    exercise.forbidden = {{.corners = {{0, 3, 1}, {1, 3, 1}, {1, 3, 2}}, .outward = Vec3::UnitY()},
                          {.corners = {{0, 0, 1}, {1, 0, 1}, {1, 1, 2}}, .outward = Vec3(1, 2, 3).normalized()}};
    return exercise;
}

TEST(ExerciseWriter, WritesWhatIsDrawn) {
    const Expected<Exercise> read = readBack(drawn());
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(*read, drawn());
}

TEST(ExerciseWriter, NamesFilesBesideItself) {
    const auto exercise = parseExercise(
        "name = \"Own\"\ntask = \"Cut.\"\ntooth = \"teeth/own.stl\"\nlayers = {dentin = \"dentin.stl\"}\n"
        "bur = \"bur.stl\"\nideal = \"ideal.stl\"\nrubric = \"our.toml\"\n",
        "own.toml", "/somewhere");
    ASSERT_TRUE(exercise) << exercise.error().message();
    const Expected<Exercise> read = readBack(*exercise, "/somewhere");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(*read, *exercise);
    const Expected<std::string> elsewhere = exerciseText(*exercise, "/elsewhere");
    ASSERT_FALSE(elsewhere);
    EXPECT_THAT(elsewhere.error().message(), testing::HasSubstr("must lie in the folder of the exercise"));
}

TEST(ExerciseWriter, LeavesTheFileAsItWasWhereItFails) {
    const test::TemporaryFolder folder;
    const auto file = folder / "own.toml";
    ASSERT_TRUE(writeExercise(drawn(), file));
    const std::string before = test::readText(file);
    Exercise bad = drawn();
    bad.bur = std::filesystem::path("/elsewhere/bur.stl");
    EXPECT_FALSE(writeExercise(bad, file));
    EXPECT_EQ(test::readText(file), before);
    const Expected<Exercise> read = readExercise(file);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->file, file);
    EXPECT_FALSE(writeExercise(drawn(), folder / "no such folder" / "own.toml"));
}

}  // namespace
}  // namespace tactooth
