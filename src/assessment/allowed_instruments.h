// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include "assessment/exercise.h"

namespace tactooth {

/// Numbers in the catalogue of the burs that serve in an exercise; empty: it has only a bur of its own.
[[nodiscard]] std::set<std::string> bursOf(const Exercise& exercise);

/// Whether a student may take a bur of the catalogue, or the one of a file.
[[nodiscard]] bool allowsBur(const Exercise& exercise, std::string_view number);
[[nodiscard]] bool allowsBurFile(const Exercise& exercise, const std::filesystem::path& file);
/// Whether a student may take a handpiece or a hand instrument.
[[nodiscard]] bool allows(const Exercise& exercise, const TrayInstrument& instrument);

/// The names of Exercise::instruments, as its file has them: "turbine, low-speed".
[[nodiscard]] std::string instrumentNames(const Exercise& exercise);

}  // namespace tactooth
