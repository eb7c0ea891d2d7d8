// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/exercise_scene.h"

#include <map>
#include <string>

namespace tactooth::test {

const ExerciseScene& ExerciseScene::of(const Exercise& exercise) {
    static std::map<std::string, ExerciseScene> made;
    const auto known = made.find(exercise.id);
    if (known != made.end()) return known->second;
    ExerciseScene scene;
    scene.tooth = *exerciseTooth(exercise);
    scene.ideal = idealShape(exercise, scene.tooth);
    return made.emplace(exercise.id, std::move(scene)).first->second;
}

}  // namespace tactooth::test
