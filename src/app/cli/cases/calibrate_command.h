// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "app/cli/cases/assess_command.h"

namespace tactooth {

struct CalibrateOptions {
    ComparisonOptions with;
    std::vector<std::filesystem::path> works;  ///< files, or folders of files
    std::filesystem::path marks;               ///< the teachers' marks
    std::filesystem::path out;                 ///< the fitted rubric
    bool json = false;                         ///< the result to the standard output as JSON
};

/// Fits a rubric to the marks of a school's teachers, writes it, and prints how far the program agrees with them.
[[nodiscard]] int runCalibrate(const CalibrateOptions& options);

}  // namespace tactooth
