// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// The built-in exercises and their words.
#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "assessment/exercise.h"
#include "assessment/exercise_file.h"
#include "assessment/messages.h"
#include "geometry/util/assert.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

constexpr std::array<const MessageText*, 10> kGroupTitles = {
    &msg::kGroupHandEye,    &msg::kGroupCaries,    &msg::kGroupFilling, &msg::kGroupClassOne,   &msg::kGroupClassTwo,
    &msg::kGroupClassThree, &msg::kGroupClassFive, &msg::kGroupCrown,   &msg::kGroupEndodontic, &msg::kGroupOwn};
constexpr std::array<const MessageText*, 3> kLevelTitles = {&msg::kLevelEasy, &msg::kLevelUsual, &msg::kLevelHard};

}  // namespace

const MessageText& titleOf(ExerciseGroup group) { return *kGroupTitles.at(static_cast<std::size_t>(group)); }

const MessageText& titleOf(ExerciseLevel level) { return *kLevelTitles.at(static_cast<std::size_t>(level)); }

bool Exercise::opensPulp() const {
    const auto* plan = std::get_if<PreparationPlan>(&ideal);
    return plan != nullptr && plan->body && plan->body->role == MaterialRole::Pulp;
}

ExerciseWords Exercise::words(Language language) const {
    if (language == Language::Japanese && !japanese.name.empty()) return japanese;
    return {name, task, brief};
}

std::span<const std::shared_ptr<const Exercise>> exercises() {
    static const std::vector<std::shared_ptr<const Exercise>> all = [] {
        std::vector<std::shared_ptr<const Exercise>> list;
        for (const auto& [name, text] : builtinExerciseTexts()) {
            Expected<Exercise> exercise = parseExercise(text, name, {});
            TACTOOTH_ASSERT(exercise.has_value());  // a test reads each of them
            if (!exercise) continue;
            exercise->id = std::filesystem::path(name).stem().native();
            list.push_back(std::make_shared<const Exercise>(std::move(*exercise)));
        }
        std::ranges::stable_sort(list, [](const auto& a, const auto& b) {
            return std::pair(a->group, a->level) < std::pair(b->group, b->level);
        });
        return list;
    }();
    return all;
}

std::shared_ptr<const Exercise> builtinExercise(std::string_view id) {
    const auto found = std::ranges::find(exercises(), id, [](const auto& one) { return std::string_view(one->id); });
    return found != exercises().end() ? *found : nullptr;
}

Expected<Exercise> findExercise(const std::string& nameOrFile) {
    if (const auto builtin = builtinExercise(nameOrFile)) return *builtin;
    const std::filesystem::path file(nameOrFile);
    if (file.has_extension() || file.has_parent_path()) return readExercise(file);
    std::string names;
    for (const auto& each : exercises()) names += (names.empty() ? "" : ", ") + each->id;
    return unexpected(msg::kExerciseUnknown, quotedWord(nameOrFile), names);
}

}  // namespace tactooth
