// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace tactooth::test {

/// The results and the resource use of a run of the program.
struct WatchedRun {
    int exitCode = -1;  ///< -1: ended by a signal: its own or, if it was late, the watcher's
    int signal = 0;
    bool isLate = false;
    std::string out;
    std::string err;
    double processorSeconds = 0;
    std::size_t peakBytes = 0;  ///< of memory
};

/// Runs the real program in `folder`. Ends it when it is late: after 30 times its permitted time, for a busy machine.
[[nodiscard]] WatchedRun watchTactooth(const std::vector<std::string>& arguments, const std::filesystem::path& folder);

/// The fault in the end of the program; empty: none. The program must end by itself with 0, 1 or 2, within 10 s of
/// processor time and 1 GB. With 2 it must print one sentence on stderr. No stream may contain control sequences that a
/// terminal obeys.
[[nodiscard]] std::string faultOf(const WatchedRun& run);

/// The same for the files in a folder that a run has written to: no text (CSV, JSON, TOML) and no surface (STL)
/// contains a number that is not finite.
[[nodiscard]] std::string faultOfFiles(const std::filesystem::path& folder);

}  // namespace tactooth::test
