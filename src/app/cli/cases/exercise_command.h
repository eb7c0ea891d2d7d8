// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace tactooth {

struct ExerciseOptions {
    std::string exercise;       ///< id of a built-in one, or a file
    std::filesystem::path out;  ///< STL of the ideal shape; empty: none
};

/// Prints the requirements of an exercise before a student gets it.
int runExercise(const ExerciseOptions& options);

}  // namespace tactooth
