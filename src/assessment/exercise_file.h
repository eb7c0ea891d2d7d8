// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "assessment/exercise.h"

namespace tactooth {

/// Reads the description of an exercise (TOML, docs/exercises.md). `name` stands for the file in messages. The files
/// that the text names lie in `folder` or below it. Fails with one sentence that names the line.
[[nodiscard]] Expected<Exercise> parseExercise(std::string_view text, const std::string& name,
                                               const std::filesystem::path& folder);

/// One file of data/exercises/, which is built into the program.
struct BuiltinExerciseText {
    const char* name;
    const char* text;
};
[[nodiscard]] std::span<const BuiltinExerciseText> builtinExerciseTexts();

/// The same from a file. Does not read the surfaces that the text names.
[[nodiscard]] Expected<Exercise> readExercise(const std::filesystem::path& file);

/// A built-in exercise by its id, or a file. Fails with one sentence.
[[nodiscard]] Expected<Exercise> findExercise(const std::string& nameOrFile);

}  // namespace tactooth
