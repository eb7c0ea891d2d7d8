// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A minute of damaged cases.
#include <gtest/gtest.h>

#include <chrono>

#include "fuzz/seed_corpus.h"
#include "session/cases/open_case.h"

namespace tactooth {
namespace {

TEST(LongCaseReaderFuzz, AMinuteOfDamageKeepsThePromises) {
    const std::vector<std::string> seeds = test::seedCorpus(TACTOOTH_CASE_CORPUS);
    const auto isAccepted = [](const std::string& bytes) {
        const auto store = CaseStore::openArchive(std::as_bytes(std::span(bytes)), "seed");
        return store ? openCase(*store).has_value() : parseCase(bytes, "seed").has_value();
    };
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    for (unsigned round = 1; std::chrono::steady_clock::now() < end; ++round) {
        test::tryDamagedSeeds(seeds, 500, round, isAccepted);
    }
}

}  // namespace
}  // namespace tactooth
