// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A minute of damaged cases.
#include <gtest/gtest.h>

#include <chrono>

#include "fuzz/case_seeds.h"

namespace tactooth {
namespace {

TEST(LongCaseReaderFuzz, AMinuteOfDamageKeepsThePromises) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    for (unsigned round = 1; std::chrono::steady_clock::now() < end; ++round) {
        test::tryDamagedSeeds(test::caseSeeds(), 5000, round, test::isAcceptedCase);
    }
}

}  // namespace
}  // namespace tactooth
