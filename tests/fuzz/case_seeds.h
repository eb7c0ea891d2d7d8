// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fuzz/seed_corpus.h"
#include "session/cases/open_case.h"

namespace tactooth::test {

/// Packed cases, and descriptions without an archive around them.
[[nodiscard]] inline const std::vector<std::string>& caseSeeds() {
    static const std::vector<std::string> seeds = seedCorpus(TACTOOTH_CASE_CORPUS);
    return seeds;
}

[[nodiscard]] inline bool isAcceptedCase(const std::string& bytes) {
    const auto store = CaseStore::openArchive(std::as_bytes(std::span(bytes)), "seed");
    return store ? openCase(*store).has_value() : parseCase(bytes, "seed").has_value();
}

}  // namespace tactooth::test
