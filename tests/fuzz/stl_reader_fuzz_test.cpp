// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The fuzz target as an ordinary test: over its seed corpus and over seeded mutations of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "fuzz/fuzz_target.h"
#include "geometry/stl_reader.h"
#include "support/mutation.h"

namespace tactooth {
namespace {

std::vector<std::string> corpus() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(TACTOOTH_STL_CORPUS)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<std::string> contents;
    for (const std::filesystem::path& path : files) {
        std::ifstream file(path, std::ios::binary);
        contents.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return contents;
}

bool isAccepted(const std::string& bytes) { return parseStl(std::as_bytes(std::span(bytes)), "seed").has_value(); }

void tryTarget(const std::string& bytes) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

TEST(StlReaderFuzz, TheCorpusHoldsGoodAndBadFiles) {
    const std::vector<std::string> seeds = corpus();
    const auto accepted = std::count_if(seeds.begin(), seeds.end(), isAccepted);
    EXPECT_GE(accepted, 6);
    EXPECT_GE(static_cast<std::ptrdiff_t>(seeds.size()) - accepted, 4);
}

TEST(StlReaderFuzz, EverySeedKeepsThePromises) {
    for (const std::string& seed : corpus()) tryTarget(seed);
}

TEST(StlReaderFuzz, MutatedSeedsKeepThePromises) {
    const std::vector<std::string> seeds = corpus();
    std::mt19937 random(20260106);
    int accepted = 0;
    constexpr int kRounds = 2000;
    for (int round = 0; round < kRounds; ++round) {
        std::string bytes = seeds[test::below(random, seeds.size())];
        const std::size_t changes = 1 + test::below(random, 2);
        for (std::size_t change = 0; change < changes; ++change) test::damage(bytes, seeds, random);
        accepted += isAccepted(bytes);
        tryTarget(bytes);
    }
    // Neither all refused nor all accepted, or the mutations would try little.
    EXPECT_GT(accepted, kRounds / 20);
    EXPECT_LT(accepted, kRounds * 19 / 20);
}

}  // namespace
}  // namespace tactooth
