// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>

#include "geometry/util/message.h"

namespace tactooth {

struct LearnedOptions {
    std::filesystem::path folder;                   ///< with reports of 'assess', at any depth
    std::filesystem::path out;                      ///< folder
    double adequate = 0.1, inadequate = 0.3;        ///< LC-CUSUM: rates of failures, 0..1
    std::size_t trials = 50;                        ///< planned
    double acceptable = 0.05, unacceptable = 0.15;  ///< CUSUM: rates of failures, 0..1
    bool json = false;                              ///< also to the standard output
    Language language = Language::English;          ///< of the page
};

/// Shows for each student and exercise whether it has been learnt, by CUSUM and LC-CUSUM, as a page and as JSON.
/// Returns kExitOk if all have learnt it, and kExitNegative if one has not shown it yet.
[[nodiscard]] int runLearned(const LearnedOptions& options);

}  // namespace tactooth
