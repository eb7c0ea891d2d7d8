// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace tactooth {

struct InfoOptions {
    std::vector<std::filesystem::path> files;
    bool json = false;  ///< one line with a JSON object for each file, instead of a table
};

/// Prints the properties of the surfaces in the files. A file that cannot be read is reported on stderr. The other
/// files are still printed; the exit code is then kExitBadInput.
[[nodiscard]] int runInfo(const InfoOptions& options);

}  // namespace tactooth
