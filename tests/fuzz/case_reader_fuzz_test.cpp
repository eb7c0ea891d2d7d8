// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The fuzz target as an ordinary test: over its corpus and over seeded mutations of it.
#include <gtest/gtest.h>

#include "fuzz/seed_corpus.h"
#include "session/cases/open_case.h"

namespace tactooth {
namespace {

const std::vector<std::string>& corpus() {
    static const std::vector<std::string> seeds = test::seedCorpus(TACTOOTH_CASE_CORPUS);
    return seeds;
}

bool isAccepted(const std::string& bytes) {
    const auto raw = std::as_bytes(std::span(bytes));
    const auto store = CaseStore::openArchive(raw, "seed");
    return store ? openCase(*store).has_value() : parseCase(bytes, "seed").has_value();
}

TEST(CaseReaderFuzz, EverySeedAndEveryBeginningOfItKeepsThePromises) {
    ASSERT_GE(corpus().size(), 5u);
    for (const std::string& seed : corpus()) {
        for (std::size_t length = 0; length <= seed.size(); length += 1 + seed.size() / 200) {
            test::tryTarget(seed.substr(0, length));
        }
    }
}

TEST(CaseReaderFuzz, MutatedSeedsKeepThePromises) { test::tryDamagedSeeds(corpus(), 1500, 20261121, isAccepted); }

}  // namespace
}  // namespace tactooth
