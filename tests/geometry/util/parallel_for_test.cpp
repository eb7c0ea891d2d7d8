// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/parallel_for.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace tactooth {
namespace {

TEST(ParallelFor, CallsEachIndexOnceWhateverTheGrain) {
    for (const std::size_t count : {0, 1, 2, 7, 1000, 4097}) {
        for (const std::size_t grain : {1, 3, 500, 5000}) {
            std::vector<int> calls(count, 0);
            parallelFor(
                count, [&](std::size_t i) { ++calls[i]; }, grain);
            EXPECT_EQ(calls, std::vector<int>(count, 1)) << "grain " << grain;
        }
    }
}

TEST(ParallelFor, SeesWhatCameBeforeAndIsSeenAfter) {
    constexpr std::size_t kCount = 1000;
    for (int round = 0; round < 50; ++round) {
        std::vector<std::size_t> input(kCount), output(kCount);
        std::iota(input.begin(), input.end(), round);
        parallelFor(kCount, [&](std::size_t i) { output[i] = 2 * input[kCount - 1 - i]; });
        for (std::size_t i = 0; i < kCount; ++i) ASSERT_EQ(output[i], 2 * (kCount - 1 - i + round));
    }
}

TEST(ParallelFor, MayBeNested) {
    constexpr std::size_t kSide = 40;
    std::vector<std::vector<std::size_t>> products(kSide, std::vector<std::size_t>(kSide));
    parallelFor(kSide, [&](std::size_t row) {
        parallelFor(kSide, [&](std::size_t column) { products[row][column] = row * column; });
        std::partial_sum(products[row].begin(), products[row].end(), products[row].begin());
    });
    for (std::size_t row = 0; row < kSide; ++row) EXPECT_EQ(products[row].back(), row * kSide * (kSide - 1) / 2);
}

}  // namespace
}  // namespace tactooth
