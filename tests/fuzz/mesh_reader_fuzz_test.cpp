// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The fuzz target as an ordinary test: over its seed corpus and over seeded mutations of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "fuzz/seed_corpus.h"
#include "geometry/obj_reader.h"
#include "geometry/ply_reader.h"

namespace tactooth {
namespace {

std::vector<std::string> corpus() { return test::seedCorpus(TACTOOTH_MESH_CORPUS); }

bool isAccepted(const std::string& bytes) {
    const auto raw = std::as_bytes(std::span(bytes));
    return parseObj(raw, "seed").has_value() || parsePly(raw, "seed").has_value();
}

TEST(MeshReaderFuzz, TheCorpusHoldsGoodAndBadFiles) {
    const std::vector<std::string> seeds = corpus();
    const auto accepted = std::count_if(seeds.begin(), seeds.end(), isAccepted);
    EXPECT_EQ(accepted, 7);
    EXPECT_EQ(static_cast<std::ptrdiff_t>(seeds.size()) - accepted, 8);
}

TEST(MeshReaderFuzz, EverySeedKeepsThePromises) {
    for (const std::string& seed : corpus()) test::tryTarget(seed);
}

TEST(MeshReaderFuzz, MutatedSeedsKeepThePromises) { test::tryDamagedSeeds(corpus(), 4000, 20261121, isAccepted); }

}  // namespace
}  // namespace tactooth
