// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace tactooth {

struct InfoOptions {
    std::vector<std::filesystem::path> files;
    bool json = false;  ///< one JSON object a line and file instead of a table
};

/// Shows what the surfaces in the files are like. A file that cannot be read is told on stderr, and the others are
/// still shown; the exit code is then kExitBadInput.
[[nodiscard]] int runInfo(const InfoOptions& options);

}  // namespace tactooth
