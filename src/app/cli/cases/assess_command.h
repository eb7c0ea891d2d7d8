// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "geometry/util/message.h"

namespace tactooth {

/// What works are compared with.
struct ComparisonOptions {
    std::filesystem::path expert;    ///< a recording, a saved tooth or a surface; empty: `exercise` says what is ideal
    std::string exercise;            ///< a file, or the name of a built-in one; empty: none
    std::string rubric;              ///< a file, or the name of a built-in one; empty: kUsualRubric
    std::filesystem::path original;  ///< the uncut tooth; empty: that of the student's file or of the exercise
    bool align = false;
};

struct AssessOptions {
    std::filesystem::path student;  ///< a recording, a saved tooth or a surface, or a folder of them
    ComparisonOptions with;
    std::string name;                       ///< of the student, for the report; empty: not known
    std::string comment;                    ///< of the teacher, for the report; empty: none
    std::filesystem::path earlier;          ///< folder with reports of earlier trials; empty: none
    std::filesystem::path out;              ///< folder
    bool json = false;                      ///< also to the standard output
    Language language = Language::English;  ///< of the pages
};

/// Measures and marks a student's work, or each work of a folder, and writes the report. Returns kExitOk if it passes
/// and kExitNegative if it fails.
[[nodiscard]] int runAssess(const AssessOptions& options);

}  // namespace tactooth
