// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tactooth {

struct ReproduceOptions {
    std::vector<std::string> what;  ///< names of experimentNames(), or "all"
    std::filesystem::path out;
};

/// All experiments that can be reproduced, in the order of 'all'.
[[nodiscard]] std::vector<std::string> experimentNames();

/// Repeats published measurements on this machine. Writes tables, plots and one page that compares the published
/// numbers with ours.
[[nodiscard]] int runReproduce(const ReproduceOptions& options);

}  // namespace tactooth
