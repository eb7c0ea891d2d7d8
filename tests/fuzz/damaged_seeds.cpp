// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/damaged_seeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "support/mutation.h"
#include "support/text_file.h"

namespace tactooth::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr unsigned kChance = 20261121;
constexpr auto kPatience = std::chrono::seconds(20);  // a thousand times what the slowest takes: it hangs, or nearly

}  // namespace

std::vector<std::string> seedsOf(const FuzzTarget& target) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(TACTOOTH_CORPUS) / target.name)) {
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::vector<std::string> seeds;
    for (const std::filesystem::path& file : files) seeds.push_back(readText(file));
    return seeds;
}

bool tryTarget(const FuzzTarget& target, const std::string& bytes) {
    try {
        return target.accepts(std::as_bytes(std::span(bytes)));
    } catch (const std::exception& broken) {
        const auto file = std::filesystem::temp_directory_path() / ("tactooth-broke-" + std::string(target.name));
        writeText(file, bytes);
        ADD_FAILURE() << "It does not hold that " << broken.what() << ": " << file;
        return false;
    }
}

int tryDamagedSeeds(const FuzzTarget& target, int mostRounds, Clock::duration longest, int leastRounds) {
    const std::vector<std::string> seeds = seedsOf(target);
    std::mt19937 random(kChance);
    const Clock::time_point begin = Clock::now();
    Clock::time_point last = begin;
    int accepted = 0, round = 0;
    const auto isDue = [&] { return round < leastRounds || (round < mostRounds && last - begin < longest); };
    while (isDue() && !testing::Test::HasFailure()) {
        std::string bytes = seeds[below(random, seeds.size())];
        for (std::size_t changes = 1 + below(random, 2); changes > 0; --changes) mutate(bytes, seeds, random);
        accepted += tryTarget(target, bytes);
        ++round;
        const Clock::time_point now = Clock::now();
        EXPECT_LT(now - last, kPatience) << "round " << round;
        last = now;
    }
    // Neither nearly all refused nor nearly all accepted, or the damage would try little.
    EXPECT_GT(accepted, target.leastAccepted * round);
    EXPECT_LT(accepted, 0.95 * round);
    return round;
}

}  // namespace tactooth::test
