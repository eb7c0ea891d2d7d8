// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/gui/editor/exercise_draft.h"

namespace tactooth {

/// A kind of cavity that the teacher begins with, and then adjusts.
enum class ExerciseTemplate { ClassOne, ClassTwoMesial, ClassTwoDistal, ClassFive };

/// Whether this tooth can have such a cavity.
[[nodiscard]] bool fits(ExerciseTemplate kind, const Exercise& exercise);

/// Gives an exercise such a cavity on its tooth, with what goes with it: bur, depth, group and rubric, and name and
/// task where there are none. `outer`: LayeredTooth::ownOuter of its tooth; `kind` fits.
void applyTemplate(ExerciseTemplate kind, Exercise& exercise, const std::shared_ptr<const SurfacePart>& outer);

/// Changes an exercise. A name and a task that a template has given, and that nobody has changed since, follow tooth,
/// kind and depth.
void changeWithWords(Exercise& exercise, const ExerciseChange& change);

/// A new exercise without a cavity, on a built-in tooth. `fdi`: a permanent tooth.
[[nodiscard]] Exercise newExercise(int fdi, bool inMouth);

/// A copy for editing, with its words in the language of the window, and with a cavity along a fissure as a drawn
/// outline. `outer`: of its tooth.
[[nodiscard]] Exercise editableCopy(const Exercise& exercise, const std::shared_ptr<const SurfacePart>& outer);

}  // namespace tactooth
