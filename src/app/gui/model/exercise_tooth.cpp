// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/exercise_tooth.h"

#include <any>
#include <utility>

namespace tactooth {

Expected<SessionTooth> makeSessionTooth(const std::shared_ptr<const Exercise>& exercise, const ShareDone& progress) {
    const auto* request = std::get_if<ToothRequest>(&exercise->tooth);
    const bool isSound = request != nullptr && (!request->lesion || request->lesion->width == 0) && !request->filling;
    const auto make = [&]() -> Expected<SessionTooth> {
        if (request == nullptr) return loadSessionTooth(std::get<ToothSource>(exercise->tooth), {}, progress);
        if (exercise->inMouth)
            return makeSessionTooth(
                MouthChoice{.fdi = request->fdi, .lesion = request->lesion, .filling = request->filling}, progress);
        return makeSessionTooth(*request, exercise->name, isSound ? ", sound" : "", progress);
    };
    Expected<SessionTooth> tooth = make();
    if (!tooth) return tooth;
    const auto* file = std::get_if<std::filesystem::path>(&exercise->bur);
    Expected<SessionBur> bur =
        file != nullptr ? loadSessionBur(*file) : makeSessionBur(*findBur(std::get<std::string>(exercise->bur)));
    if (!bur) return Unexpected{bur.error()};
    tooth->name = exercise->name;
    tooth->provenance.emplace_back("exercise", exercise->name);
    tooth->bur = std::move(*bur);
    setExercise(*tooth, exercise);
    return tooth;
}

std::shared_ptr<const Exercise> exerciseOf(const SessionTooth& tooth) {
    const auto* exercise = std::any_cast<std::shared_ptr<const Exercise>>(&tooth.purpose);
    return exercise != nullptr ? *exercise : nullptr;
}

void setExercise(SessionTooth& tooth, std::shared_ptr<const Exercise> exercise) { tooth.purpose = std::move(exercise); }

int fdiOf(const Exercise& exercise) {
    const auto* request = std::get_if<ToothRequest>(&exercise.tooth);
    return request != nullptr ? request->fdi : 0;
}

int fdiOf(const SessionTooth& tooth) {
    if (tooth.mouthTooth != 0) return tooth.mouthTooth;
    if (const auto exercise = exerciseOf(tooth)) return fdiOf(*exercise);
    return fdiOfTooth(tooth);
}

}  // namespace tactooth
