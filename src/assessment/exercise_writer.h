// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "assessment/exercise.h"

namespace tactooth {

/// An exercise as TOML (docs/exercises.md) that parseExercise reads back as the same, with numbers in their shortest
/// exact form. `folder`: where the file will lie; the files that the exercise names must lie there or below. Fails with
/// one sentence.
[[nodiscard]] Expected<std::string> exerciseText(const Exercise& exercise, const std::filesystem::path& folder);

/// Writes it: afterwards `file` holds the exercise, or there is an error and `file` is unchanged.
[[nodiscard]] Expected<void> writeExercise(const Exercise& exercise, const std::filesystem::path& file);

}  // namespace tactooth
