// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "assessment/exercise.h"

namespace tactooth {

/// Where the exercises that the user makes are kept: $XDG_DATA_HOME/tactooth/exercises, else
/// ~/.local/share/tactooth/exercises. Empty if neither is known.
[[nodiscard]] std::filesystem::path ownExerciseFolder();

struct OwnExercises {
    std::vector<std::shared_ptr<const Exercise>> exercises;  ///< in the order of their files' names
    std::vector<Error> faults;                               ///< of the files that cannot be used
};
/// All files *.toml of a folder; none if there is no such folder.
[[nodiscard]] OwnExercises readOwnExercises(const std::filesystem::path& folder);

}  // namespace tactooth
