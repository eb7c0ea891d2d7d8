// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/editor/exercise_draft.h"

#include <gtest/gtest.h>

#include "app/gui/editor/exercise_template.h"
#include "assessment/exercise_file.h"
#include "assessment/exercise_keys.h"
#include "assessment/exercise_writer.h"

namespace tactooth {
namespace {

constexpr DraftLine kCavity;

std::string_view problemOf(const ExerciseDraft& draft, const std::shared_ptr<const SurfacePart>& outer = nullptr) {
    static Message last;
    last = draft.problem(outer).value_or(Message());
    return last.id();
}

/// A square of 3 mm from above, with a name and a task.
ExerciseDraft squareDraft() {
    Exercise exercise = newExercise(36, false);
    exercise.name = "Square";
    exercise.task = "Cut it.";
    ExerciseDraft draft(exercise);
    for (const Vec3& corner : {Vec3(0, 0, 6), Vec3(3, 0, 6), Vec3(3, 3, 6), Vec3(0, 3, 6)})
        draft.addPoint(kCavity, corner, Vec3::UnitZ());
    draft.closeLine();
    return draft;
}

TEST(ExerciseDraft, SaysWhatIsMissingUntilItIsComplete) {
    ExerciseDraft draft(newExercise(36, false));
    EXPECT_EQ(problemOf(draft), "draft_no_outline");
    for (const Vec3& corner : {Vec3(0, 0, 6), Vec3(3, 0, 6), Vec3(3, 3, 6), Vec3(0, 3, 6)})
        draft.addPoint(kCavity, corner, Vec3::UnitZ());
    EXPECT_EQ(problemOf(draft), "draft_open_outline");
    draft.closeLine();
    EXPECT_EQ(problemOf(draft), "draft_name");
    draft.change("", [](Exercise& exercise) { exercise.name = "Square"; });
    EXPECT_EQ(problemOf(draft), "draft_task");
    draft.change("", [](Exercise& exercise) { exercise.task = "Cut it."; });
    EXPECT_EQ(problemOf(draft), "");
}

/// Whatever made the cavity before: afterwards the outline alone does.
TEST(ExerciseDraft, AnOutlineTakesThePlaceOfAnyOtherIdeal) {
    for (const char* id : {"crown-46", "class-1-46", "caries-46", "class-5-43"}) {
        ExerciseDraft draft(*builtinExercise(id));
        draft.clearOutline();
        for (const Vec3& corner : {Vec3(0, 0, 6), Vec3(3, 0, 6), Vec3(3, 3, 6), Vec3(0, 3, 6)})
            draft.addPoint(kCavity, corner, Vec3::UnitZ());
        draft.closeLine();
        const auto text = exerciseText(draft.exercise(), {});
        ASSERT_TRUE(text) << text.error().message();
        const auto read = parseExercise(*text, "drawn.toml", {});
        ASSERT_TRUE(read) << id << ": " << read.error().message();
        const auto& plan = std::get<PreparationPlan>(read->ideal);
        EXPECT_TRUE(plan.outline) << id;
        EXPECT_FALSE(plan.crown || plan.fissure || plan.body || !plan.strokes.empty()) << id;
        EXPECT_EQ(plan, *draft.plan()) << id;
    }
}

TEST(ExerciseDraft, ACrownTakesTheEndOfItsBur) {
    Exercise exercise = *builtinExercise("crown-46");
    const double before = std::get<PreparationPlan>(exercise.ideal).crown->tipRadius;
    takeBur(exercise, *findBur("57"));  // flat
    EXPECT_GT(before, 0.4);
    EXPECT_EQ(std::get<PreparationPlan>(exercise.ideal).crown->tipRadius, 0);
}

TEST(ExerciseDraft, FindsLinesThatMakeNoCavity) {
    ExerciseDraft crossed = squareDraft();
    crossed.movePoint(kCavity, 1, Vec3(0, 4, 6), "");
    EXPECT_EQ(problemOf(crossed), "draft_outline_crosses");
    ExerciseDraft narrow = squareDraft();
    narrow.movePoint(kCavity, 2, Vec3(3, 0.5, 6), "");
    narrow.movePoint(kCavity, 3, Vec3(0, 0.5, 6), "");
    EXPECT_EQ(problemOf(narrow), "draft_outline_narrow");
    ExerciseDraft leaning = squareDraft();
    leaning.change("", [](Exercise& exercise) {
        auto& plan = std::get<PreparationPlan>(exercise.ideal);
        plan.depth = 3;
        plan.outline->taperDegrees = 25;  // 1.4 mm on each side
    });
    EXPECT_EQ(problemOf(leaning), "draft_floor_narrow");
    ExerciseDraft zone = squareDraft();
    const DraftLine line = zone.beginZone();
    zone.addPoint(line, Vec3(0, 4, 1), Vec3::UnitY());
    EXPECT_EQ(problemOf(zone), "draft_zone_small");
    zone.addPoint(line, Vec3(1, 4, 1), Vec3::UnitY());
    zone.addPoint(line, Vec3(1, 4, 2), Vec3::UnitY());
    EXPECT_EQ(problemOf(zone), "draft_open_outline");
    zone.closeLine();
    EXPECT_EQ(problemOf(zone), "");
    zone.removePoint(line, 0);
    EXPECT_NE(problemOf(zone), "");
}

/// Words and zones keep an exercise from being tried, but not its cavity from being shown.
TEST(ExerciseDraft, FindsWhatKeepsItFromHavingAnIdeal) {
    const auto problemOfIdeal = [](const ExerciseDraft& draft) {
        return std::string(draft.problemOfIdeal(nullptr).value_or(Message()).id());
    };
    ExerciseDraft draft = squareDraft();
    draft.change("", [](Exercise& exercise) { exercise.name.clear(); });
    const DraftLine zone = draft.beginZone();
    for (const Vec3& corner : {Vec3(0, 4, 1), Vec3(1, 4, 1), Vec3(1, 4, 2)})
        draft.addPoint(zone, corner, Vec3::UnitY());
    EXPECT_EQ(problemOf(draft), "draft_open_outline");
    EXPECT_EQ(problemOfIdeal(draft), "");
    draft.movePoint(kCavity, 1, Vec3(0, 4, 6), "");
    EXPECT_EQ(problemOfIdeal(draft), "draft_outline_crosses");
    draft.clearOutline();
    EXPECT_EQ(problemOfIdeal(draft), "draft_no_outline");
    for (const Vec3& corner : {Vec3(0, 0, 6), Vec3(3, 0, 6), Vec3(3, 3, 6), Vec3(0, 3, 6)})
        draft.addPoint(kCavity, corner, Vec3::UnitZ());
    EXPECT_EQ(problemOfIdeal(draft), "draft_open_outline");
    draft.closeLine();
    EXPECT_EQ(problemOfIdeal(draft), "");
}

TEST(ExerciseDraft, PutsANewPointIntoTheNearestEdge) {
    ExerciseDraft draft = squareDraft();
    EXPECT_EQ(draft.addPoint(kCavity, Vec3(3.2, 1.5, 6), Vec3::UnitZ()), 2U);
    EXPECT_EQ(draft.points(kCavity)[2], Vec3(3.2, 1.5, 6));
    EXPECT_EQ(draft.points(kCavity).size(), 5U);
    EXPECT_FALSE(draft.openLine());
}

TEST(ExerciseDraft, TakesTheSideOfItsFirstPoint) {
    Exercise exercise = newExercise(46, false);
    std::get<PreparationPlan>(exercise.ideal).boxes = {{.towardX = 1, .width = 3, .axialDepth = 1.4, .axialHeight = 1}};
    ExerciseDraft draft(exercise);
    draft.addPoint(kCavity, Vec3(0, 4, 2), sideOf(exercise, Vec3(0.2, 0.9, 0.3)));
    EXPECT_EQ(draft.plan()->outward, Vec3::UnitY());
    EXPECT_FALSE(draft.plan()->isFlat);
    EXPECT_TRUE(draft.plan()->boxes.empty());
    EXPECT_EQ(sideOf(exercise, Vec3(-0.9, 0.1, 0.1)), -Vec3::UnitX());  // mesial of 46
}

TEST(ExerciseDraft, UndoesAndRedoesStepByStep) {
    ExerciseDraft draft = squareDraft();
    const Exercise before = draft.exercise();
    draft.movePoint(kCavity, 0, Vec3(-0.5, 0, 6), "drag 1");
    draft.movePoint(kCavity, 0, Vec3(-1, 0, 6), "drag 1");
    draft.endStep();
    draft.movePoint(kCavity, 0, Vec3(-2, 0, 6), "drag 1");  // by another drag
    draft.undo();
    EXPECT_EQ(draft.points(kCavity)[0], Vec3(-1, 0, 6));
    draft.undo();
    EXPECT_EQ(draft.exercise(), before);
    draft.redo();
    draft.redo();
    EXPECT_EQ(draft.points(kCavity)[0], Vec3(-2, 0, 6));
    EXPECT_FALSE(draft.canRedo());
    draft.undo();
    draft.removePoint(kCavity, 3);
    EXPECT_FALSE(draft.canRedo());
    while (draft.canUndo()) draft.undo();
    EXPECT_TRUE(draft.points(kCavity).empty());
    EXPECT_FALSE(draft.openLine());
}

TEST(ExerciseDraft, IsModifiedUntilItIsSaved) {
    ExerciseDraft draft(newExercise(36, false));
    EXPECT_FALSE(draft.isModified());
    draft.change("editName", [](Exercise& exercise) { exercise.name = "A"; });
    EXPECT_TRUE(draft.isModified());
    draft.undo();
    EXPECT_FALSE(draft.isModified());
    draft.redo();
    draft.markSaved("/somewhere/a.toml");
    EXPECT_FALSE(draft.isModified());
    EXPECT_EQ(draft.exercise().file, "/somewhere/a.toml");
    draft.undo();
    EXPECT_TRUE(draft.isModified());
}

TEST(ExerciseDraft, TakesOverTheMeasuresOfAnotherBur) {
    ExerciseDraft draft = squareDraft();
    draft.change("", [](Exercise& exercise) { takeBur(exercise, *findBur("4")); });
    EXPECT_EQ(draft.plan()->outline->burRadius, 0.7);
    EXPECT_EQ(std::get<std::string>(draft.exercise().bur), "4");
}

TEST(ExerciseTemplate, MakesCompleteExercisesOnTeethOfEachKind) {
    int made = 0;
    for (const int fdi : {36, 14, 45, 11}) {
        const Exercise empty = newExercise(fdi, false);
        const auto outer = (*exerciseTooth(empty))->ownOuter();
        for (const ExerciseTemplate kind : {ExerciseTemplate::ClassOne, ExerciseTemplate::ClassTwoMesial,
                                            ExerciseTemplate::ClassTwoDistal, ExerciseTemplate::ClassFive}) {
            EXPECT_EQ(fits(kind, empty), fdi != 11 || kind == ExerciseTemplate::ClassFive);
            if (!fits(kind, empty)) continue;
            Exercise exercise = empty;
            applyTemplate(kind, exercise, outer);
            const ExerciseDraft draft(exercise);
            EXPECT_EQ(problemOf(draft, outer), "") << fdi << ' ' << static_cast<int>(kind);
            const auto text = exerciseText(exercise, "/somewhere");
            ASSERT_TRUE(text);
            const auto read = parseExercise(*text, "made.toml", "/somewhere");
            ASSERT_TRUE(read) << read.error().message();
            EXPECT_EQ(*read, exercise);
            ++made;
        }
    }
    EXPECT_EQ(made, 13);
}

TEST(ExerciseTemplate, LetsWordsThatNobodyHasChangedFollow) {
    Exercise exercise = newExercise(36, false);
    applyTemplate(ExerciseTemplate::ClassFive, exercise, (*exerciseTooth(exercise))->ownOuter());
    EXPECT_EQ(exercise.name, "Class V, 36");
    const auto setDepth = [](double depth) {
        return [depth](Exercise& changed) { std::get<PreparationPlan>(changed.ideal).depth = depth; };
    };
    changeWithWords(exercise, setDepth(1.4));
    EXPECT_NE(exercise.task.find("1.4 mm"), std::string::npos);
    changeWithWords(exercise, [](Exercise& changed) { changed.task = "Ours."; });
    changeWithWords(exercise, setDepth(1.6));
    EXPECT_EQ(exercise.task, "Ours.");
    changeWithWords(exercise, [](Exercise& changed) { changed.group = ExerciseGroup::Own; });
    EXPECT_EQ(exercise.name, "Your own, 36");
}

TEST(ExerciseTemplate, DrawsTheFissureOfACopy) {
    const auto original = builtinExercise("class-2-36-do");
    const auto outer = (*exerciseTooth(*original))->ownOuter();
    const Exercise copy = editableCopy(*original, outer);
    const auto& plan = std::get<PreparationPlan>(copy.ideal);
    EXPECT_FALSE(plan.fissure);
    ASSERT_TRUE(plan.outline);
    EXPECT_EQ(plan.boxes.size(), 1U);
    EXPECT_TRUE(copy.id.empty());
    EXPECT_EQ(problemOf(ExerciseDraft(copy), outer), "");
    const Exercise body = editableCopy(*builtinExercise("caries-46"), nullptr);
    EXPECT_TRUE(std::get<PreparationPlan>(body.ideal).body);  // nothing to draw: it stays
}

TEST(ExerciseDraft, NoticesAnOutlineThatDoesNotReachItsBox) {
    Exercise exercise = newExercise(36, false);
    const auto outer = (*exerciseTooth(exercise))->ownOuter();
    applyTemplate(ExerciseTemplate::ClassTwoMesial, exercise, outer);
    auto& boxes = std::get<PreparationPlan>(exercise.ideal).boxes;
    boxes.front().towardX = -boxes.front().towardX;
    EXPECT_EQ(problemOf(ExerciseDraft(exercise), outer), "draft_distal_box");
    boxes.front().axialDepth = 0.5;
    EXPECT_EQ(problemOf(ExerciseDraft(exercise), outer), "draft_box_narrow");
}

const Lesion& lesionOf(const ExerciseDraft& draft) { return *std::get<ToothRequest>(draft.exercise().tooth).lesion; }

TEST(ExerciseDraft, DecayIsPaintedPlaceByPlace) {
    ExerciseDraft draft(newExercise(36, false));
    EXPECT_TRUE(draft.decay().empty());
    draft.addDecay(Vec3(0, 0, 6), "stroke");
    for (int i = 1; i <= 100; ++i) draft.addDecay(Vec3(0.03 * i, 0, 6), "stroke");
    const std::size_t count = draft.decay().size();
    EXPECT_GE(count, 3U);
    EXPECT_LE(count, 5U) << "places lie a third of the width apart";
    EXPECT_EQ(draft.decay().front(), Vec3(0, 0, 6));
    EXPECT_EQ(lesionOf(draft).spread.size(), count - 1);
    draft.endStep();
    draft.addDecay(Vec3(0, 3, 6), "another");
    EXPECT_EQ(draft.decay().size(), count + 1);
    draft.undo();
    EXPECT_EQ(draft.decay().size(), count);
    draft.undo();
    EXPECT_TRUE(draft.decay().empty()) << "a stroke is one step";
    draft.redo();
    const Vec3 second = draft.decay()[1];
    draft.removeDecay(0);
    EXPECT_EQ(draft.decay().front(), second);
    while (!draft.decay().empty()) draft.removeDecay(0);
    EXPECT_FALSE(std::get<ToothRequest>(draft.exercise().tooth).lesion);
    for (int i = 0; i < 200; ++i) draft.addDecay(Vec3(0, 2.0 * i, 6), "many");
    EXPECT_EQ(lesionOf(draft).spread.size(), kMostDecayPlaces);
}

TEST(ExerciseDraft, ARimBringsTheMaterialOfAffectedDentin) {
    ExerciseDraft draft = squareDraft();
    EXPECT_FALSE(mayHaveRim(draft.exercise())) << "it has no decay";
    draft.addDecay(Vec3(0, 0, 6), {});
    ASSERT_TRUE(mayHaveRim(draft.exercise()));
    draft.change({}, [](Exercise& exercise) { setRim(exercise, 0.6); });
    ASSERT_TRUE(lesionOf(draft).rim);
    EXPECT_EQ(draft.exercise().materials->nameOf(lesionOf(draft).rim->material), "affected-dentin");
    const auto text = exerciseText(draft.exercise(), {});
    ASSERT_TRUE(text) << text.error().message();
    const auto read = parseExercise(*text, "own.toml", {});
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(*read, draft.exercise());
    draft.change({}, [](Exercise& exercise) { setRim(exercise, 0); });
    EXPECT_FALSE(lesionOf(draft).rim);
}

}  // namespace
}  // namespace tactooth
