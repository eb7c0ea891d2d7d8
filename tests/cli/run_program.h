// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tactooth::test {

/// What a run of the program left behind.
struct ProgramRun {
    int exitCode = -1;
    std::string out;
    std::string err;
};

/// Variables that are other than here; nullopt: not set.
using Environment = std::map<std::string, std::optional<std::string>>;

/// Runs the real program with `arguments` (no shell in between) and waits for its end.
[[nodiscard]] ProgramRun runTactooth(const std::vector<std::string>& arguments, const Environment& changes = {});

}  // namespace tactooth::test
