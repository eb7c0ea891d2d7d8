// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/exercise_scene.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "support/materials.h"

namespace tactooth::test {

namespace {

/// The uncut teeth beside; null where the exercise has none.
std::shared_ptr<const SurfacePart> neighboursOf(const Exercise& exercise) {
    const std::optional<ToothInMouth> made = exerciseMouth(exercise);
    if (!made) return nullptr;
    TriangleMesh mesh;
    for (const BuiltinTooth& tooth : made->beside) append(mesh, tooth.outer);
    return mesh.empty() ? nullptr : std::make_shared<const SurfacePart>(std::move(mesh));
}

}  // namespace

const ExerciseScene& ExerciseScene::of(const Exercise& exercise) {
    static std::map<std::string, ExerciseScene> made;
    const auto known = made.find(exercise.id);
    if (known != made.end()) return known->second;
    ExerciseScene scene;
    scene.tooth = *exerciseTooth(exercise);
    scene.ideal = idealShape(exercise, scene.tooth);
    scene.neighbours = neighboursOf(exercise);
    return made.emplace(exercise.id, std::move(scene)).first->second;
}

Preparation ExerciseScene::preparation(const Exercise& exercise) const {
    Preparation preparation;
    preparation.tooth = tooth;
    preparation.original = tooth->ownOuter();
    preparation.ideal = std::make_shared<const SurfacePart>(*ideal);
    preparation.axis = std::get<PreparationPlan>(exercise.ideal).outward;
    preparation.mesialX = tooth->toothContext().mesialX;
    preparation.forbidden = exercise.forbidden;
    preparation.neighbours = neighbours;
    preparation.gums = exerciseGums(exercise);
    for (const LayeredTooth::Layer& layer : tooth->layers()) {
        if (layer.material == kPulp) preparation.pulps.push_back(layer.part);
    }
    return preparation;
}

}  // namespace tactooth::test
