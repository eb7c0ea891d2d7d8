// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The fuzz target as an ordinary test: over its seed corpus and over seeded mutations of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "fuzz/seed_corpus.h"
#include "geometry/stl_reader.h"

namespace tactooth {
namespace {

std::vector<std::string> corpus() { return test::seedCorpus(TACTOOTH_STL_CORPUS); }

bool isAccepted(const std::string& bytes) { return parseStl(std::as_bytes(std::span(bytes)), "seed").has_value(); }

TEST(StlReaderFuzz, TheCorpusHoldsGoodAndBadFiles) {
    const std::vector<std::string> seeds = corpus();
    const auto accepted = std::count_if(seeds.begin(), seeds.end(), isAccepted);
    EXPECT_GE(accepted, 6);
    EXPECT_GE(static_cast<std::ptrdiff_t>(seeds.size()) - accepted, 4);
}

TEST(StlReaderFuzz, EverySeedKeepsThePromises) {
    for (const std::string& seed : corpus()) test::tryTarget(seed);
}

TEST(StlReaderFuzz, MutatedSeedsKeepThePromises) { test::tryDamagedSeeds(corpus(), 2000, 20260106, isAccepted); }

}  // namespace
}  // namespace tactooth
