// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace tactooth {

struct SessionExportOptions {
    std::filesystem::path session;
    std::filesystem::path out;
    double rateHz = 100;  ///< only for MCAP
};
/// Each replays a recording and writes what it sees. Returns an ExitCode: negative if the replay differs from the
/// recording; then the file ends there.
[[nodiscard]] int runSessionExportCsv(const SessionExportOptions& options);
[[nodiscard]] int runSessionExportMcap(const SessionExportOptions& options);

}  // namespace tactooth
