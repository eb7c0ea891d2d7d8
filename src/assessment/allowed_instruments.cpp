// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/allowed_instruments.h"

#include <algorithm>

#include "assessment/exercise_keys.h"
#include "instruments/bur_catalogue.h"

namespace tactooth {

std::set<std::string> bursOf(const Exercise& exercise) {
    std::vector<std::string> numbers = exercise.otherBurs;
    if (const auto* number = std::get_if<std::string>(&exercise.bur)) numbers.push_back(*number);
    std::set<std::string> burs;
    for (const std::string& number : numbers) {
        if (const auto bur = findBur(number)) burs.insert(bur->number);
    }
    return burs;
}

bool allowsBur(const Exercise& exercise, std::string_view number) {
    return !exercise.onlyTheseBurs || bursOf(exercise).contains(std::string(number));
}

bool allowsBurFile(const Exercise& exercise, const std::filesystem::path& file) {
    const auto* own = std::get_if<std::filesystem::path>(&exercise.bur);
    return !exercise.onlyTheseBurs || (own != nullptr && *own == file);
}

bool allows(const Exercise& exercise, const TrayInstrument& instrument) {
    const auto& allowed = exercise.instruments;
    return allowed.empty() || std::ranges::find(allowed, instrument) != allowed.end();
}

std::string instrumentNames(const Exercise& exercise) {
    std::string names;
    for (const auto& [key, instrument] : kInstrumentKeys) {
        const bool isListed = std::ranges::find(exercise.instruments, instrument) != exercise.instruments.end();
        if (isListed) names += (names.empty() ? "" : ", ") + std::string(key);
    }
    return names;
}

}  // namespace tactooth
