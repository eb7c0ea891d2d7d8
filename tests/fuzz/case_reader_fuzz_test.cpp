// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The fuzz target as an ordinary test: over its corpus and over seeded mutations of it.
#include <gtest/gtest.h>

#include "fuzz/case_seeds.h"

namespace tactooth {
namespace {

TEST(CaseReaderFuzz, EverySeedAndEveryBeginningOfItKeepsThePromises) {
    ASSERT_GE(test::caseSeeds().size(), 5u);
    for (const std::string& seed : test::caseSeeds()) {
        for (std::size_t length = 0; length <= seed.size(); length += 1 + seed.size() / 200) {
            test::tryTarget(seed.substr(0, length));
        }
    }
}

TEST(CaseReaderFuzz, MutatedSeedsKeepThePromises) {
    test::tryDamagedSeeds(test::caseSeeds(), 1500, 20261121, test::isAcceptedCase);
}

}  // namespace
}  // namespace tactooth
