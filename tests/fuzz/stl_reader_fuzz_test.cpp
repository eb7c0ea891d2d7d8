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

std::size_t below(std::mt19937& random, std::size_t limit) { return random() % std::max<std::size_t>(limit, 1); }

/// Changes a byte, flips a bit, cuts, repeats, or moves a piece from another seed in.
void mutate(std::string& bytes, const std::vector<std::string>& seeds, std::mt19937& random) {
    const std::size_t at = below(random, bytes.size());
    const std::size_t length = below(random, 60);
    const std::string& other = seeds[below(random, seeds.size())];
    switch (random() % 6) {
        case 0:
            bytes[at] = static_cast<char>(random());
            break;
        case 1:
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
            break;
        case 2:
            bytes.erase(at, length);
            break;
        case 3:
            bytes.insert(at, bytes.substr(at, length));
            break;
        case 4:
            bytes.resize(at + 1);
            break;
        default:
            bytes.insert(at, other.substr(below(random, other.size()), length));
    }
    if (bytes.empty()) bytes = other;
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
        std::string bytes = seeds[below(random, seeds.size())];
        const std::size_t changes = 1 + below(random, 2);
        for (std::size_t change = 0; change < changes; ++change) mutate(bytes, seeds, random);
        accepted += isAccepted(bytes);
        tryTarget(bytes);
    }
    // Neither all refused nor all accepted, or the mutations would try little.
    EXPECT_GT(accepted, kRounds / 20);
    EXPECT_LT(accepted, kRounds * 19 / 20);
}

}  // namespace
}  // namespace tactooth
