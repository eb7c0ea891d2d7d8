// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/triple_buffer.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <thread>

namespace tactooth {
namespace {

TEST(TripleBuffer, ReaderSeesTheNewestAndEachOnlyOnce) {
    TripleBuffer<int> mailbox(-1);
    EXPECT_FALSE(mailbox.refresh());
    EXPECT_EQ(mailbox.value(), -1);
    for (int i = 0; i < 10; ++i) mailbox.write(i);
    EXPECT_TRUE(mailbox.refresh());
    EXPECT_EQ(mailbox.value(), 9);
    EXPECT_FALSE(mailbox.refresh());
    EXPECT_EQ(mailbox.value(), 9);
}

TEST(TripleBuffer, AcrossThreadsValuesAreWholeAndNeverGoBack) {
    constexpr std::uint64_t kLast = 200000;
    TripleBuffer<std::array<std::uint64_t, 16>> mailbox;
    std::jthread writer([&] {
        std::array<std::uint64_t, 16> value;
        for (std::uint64_t i = 1; i <= kLast; ++i) {
            value.fill(i);
            mailbox.write(value);
        }
    });
    std::uint64_t last = 0;
    while (last != kLast) {
        if (!mailbox.refresh()) continue;
        const auto& value = mailbox.value();
        ASSERT_GT(value[0], last);
        last = value[0];
        for (const std::uint64_t part : value) ASSERT_EQ(part, last);
    }
}

}  // namespace
}  // namespace tactooth
