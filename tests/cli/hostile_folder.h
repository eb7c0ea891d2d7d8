// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "cli/watched_run.h"
#include "support/test_data.h"

namespace tactooth::test {

/// The arguments of a run; "@" stands for the hostile file or number.
using Attack = std::vector<std::string>;

/// Number of runs of a test: `usual`, or as many hundredths of it as TACTOOTH_HOSTILE says (3400: 34 times).
[[nodiscard]] std::size_t hostileRuns(std::size_t usual);

/// A folder in which a test attacks the program: valid inputs in in/, and the output of a run in out/.
class HostileFolder {
public:
    HostileFolder();

    [[nodiscard]] std::filesystem::path input(const std::string& name) const { return folder_ / "in" / name; }
    /// Runs an attack and empties out/. Returns the fault in the exit or in the output; empty if there is none. A run
    /// that failed must leave nothing.
    [[nodiscard]] std::string tried(const Attack& attack, const std::string& instead);
    /// The number of exits with each code.
    [[nodiscard]] const std::map<int, int>& ends() const { return ends_; }

private:
    TemporaryFolder folder_;
    std::map<int, int> ends_;
};

/// The arguments in one line, for a message.
[[nodiscard]] std::string shownAttack(const Attack& attack, const std::string& instead);

}  // namespace tactooth::test
