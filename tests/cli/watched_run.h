// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace tactooth::test {

/// What a run of the program left behind, and what it took.
struct WatchedRun {
    int exitCode = -1;  ///< -1: it was ended by a signal, its own or, when it was late, that of the watcher
    int signal = 0;
    bool isLate = false;
    std::string out;
    std::string err;
    double processorSeconds = 0;
    std::size_t peakBytes = 0;  ///< of memory
};

/// Runs the real program in `folder` and ends it when it is late: ten times what it may take, for a busy machine.
[[nodiscard]] WatchedRun watchTactooth(const std::vector<std::string>& arguments, const std::filesystem::path& folder);

/// What is wrong with how the program ended; empty: nothing. It has to end by itself with 0, 1 or 2 and within 10 s of
/// a processor and 1 GB, with one sentence on stderr if it is 2, and with nothing for a terminal to obey on any stream.
[[nodiscard]] std::string faultOf(const WatchedRun& run);

/// The same for the files in a folder that a run has written to: no text (CSV, JSON, TOML) or surface (STL) holds a
/// number that is not finite.
[[nodiscard]] std::string faultOfFiles(const std::filesystem::path& folder);

}  // namespace tactooth::test
