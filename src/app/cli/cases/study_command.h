// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "geometry/util/message.h"

namespace tactooth {

struct StudyOptions {
    std::string exercise;   ///< a file, or the name of a built-in one
    std::string rubric;     ///< a file, or the name of a built-in one; empty: that of the exercise
    std::size_t hands = 5;  ///< of each level
    std::uint64_t seed = 1;
    std::filesystem::path out;              ///< folder
    bool record = false;                    ///< leaves a recording of each hand
    bool json = false;                      ///< also to the standard output
    Language language = Language::English;  ///< of the page
};

/// Lets synthetic hands work at an exercise, and writes what the metrics make of them. Returns kExitOk if the self-test
/// passes and kExitNegative if not.
[[nodiscard]] int runStudy(const StudyOptions& options);

}  // namespace tactooth
