// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "assessment/exercise.h"

namespace tactooth {

/// Reads an exercise that a teacher has described (docs/exercises.md): TOML. `name` stands for the file in messages;
/// the files that the text names lie in `folder` or below it. Fails with one sentence that names the line.
[[nodiscard]] Expected<Exercise> parseExercise(std::string_view text, const std::string& name,
                                               const std::filesystem::path& folder);

/// One file of data/exercises/, which is built into the program.
struct BuiltinExerciseText {
    const char* name;
    const char* text;
};
[[nodiscard]] std::span<const BuiltinExerciseText> builtinExerciseTexts();

/// The same from a file. Reads the text alone, none of the surfaces that it names.
[[nodiscard]] Expected<Exercise> readExercise(const std::filesystem::path& file);

}  // namespace tactooth
