// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <ostream>
#include <string>
#include <vector>

#include "fuzz/fuzz_target.h"

namespace tactooth::test {

[[nodiscard]] inline std::string nameOfFuzzTarget(const testing::TestParamInfo<FuzzTarget>& info) {
    return info.param.name;
}

inline void PrintTo(const FuzzTarget& target, std::ostream* out) { *out << target.name; }

/// The files of the target's corpus, in the order of their names.
[[nodiscard]] std::vector<std::string> seedsOf(const FuzzTarget& target);

/// Tries the target; a broken promise fails the test and leaves the bytes in a file. True if they are accepted.
bool tryTarget(const FuzzTarget& target, const std::string& bytes);

/// Tries the target on files of its corpus that are damaged once or twice, in rounds of seeded chance until either the
/// rounds or the time are over, but for `leastRounds`, however long they take. Fails also if nearly all or nearly none
/// of them are accepted, or one takes seconds. Gives the number of rounds.
int tryDamagedSeeds(const FuzzTarget& target, int mostRounds, std::chrono::steady_clock::duration longest,
                    int leastRounds = 0);

}  // namespace tactooth::test
