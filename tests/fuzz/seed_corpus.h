// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "fuzz/fuzz_target.h"
#include "support/mutation.h"
#include "support/text_file.h"

namespace tactooth::test {

/// The files of a folder, in the order of their names.
[[nodiscard]] inline std::vector<std::string> seedCorpus(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<std::string> contents;
    for (const std::filesystem::path& path : files) contents.push_back(readText(path));
    return contents;
}

inline void tryTarget(const std::string& bytes) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

/// Tries the target on files of the corpus that are damaged once or twice.
template <class IsAccepted>
void tryDamagedSeeds(const std::vector<std::string>& seeds, int rounds, unsigned randomSeed, IsAccepted&& isAccepted) {
    std::mt19937 random(randomSeed);
    int accepted = 0;
    for (int round = 0; round < rounds; ++round) {
        std::string bytes = seeds[below(random, seeds.size())];
        const std::size_t changes = 1 + below(random, 2);
        for (std::size_t change = 0; change < changes; ++change) damage(bytes, seeds, random);
        accepted += isAccepted(bytes);
        tryTarget(bytes);
    }
    // Neither all refused nor all accepted, or the mutations would try little.
    EXPECT_GT(accepted, rounds / 20);
    EXPECT_LT(accepted, rounds * 19 / 20);
}

}  // namespace tactooth::test
