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

/// How many runs a test makes: `usual`, or as many hundredths of it as TACTOOTH_HOSTILE says (3400: 34 times).
[[nodiscard]] std::size_t hostileRuns(std::size_t usual);

/// A folder in which a program is attacked: good inputs in in/, and what a run writes in out/.
class HostileFolder {
public:
    HostileFolder();

    [[nodiscard]] std::filesystem::path input(const std::string& name) const { return folder_ / "in" / name; }
    /// Runs an attack, says what is wrong with how it ended or with what it wrote (a run that failed leaves nothing),
    /// and empties out/.
    [[nodiscard]] std::string tried(const Attack& attack, const std::string& instead);
    /// How often the program ended with each code.
    [[nodiscard]] const std::map<int, int>& ends() const { return ends_; }

private:
    TemporaryFolder folder_;
    std::map<int, int> ends_;
};

/// The arguments in one line, for a message.
[[nodiscard]] std::string shownAttack(const Attack& attack, const std::string& instead);

}  // namespace tactooth::test
