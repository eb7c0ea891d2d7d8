// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/format/container_blocks.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/expect_assert.h"

namespace tactooth {
namespace {

/// Every other length of a payload is refused.
template <class Parse>
void expectOneLength(const std::vector<std::byte>& payload, Parse parse) {
    for (std::size_t size = 0; size < payload.size() + 20; ++size) {
        std::vector<std::byte> other = payload;
        other.resize(size);
        EXPECT_EQ(parse(other).has_value(), size == payload.size()) << size;
    }
}

TEST(ContainerBlocks, ComeBack) {
    const std::vector<KeyframePlace> keyframes{{0, 100}, {1000, 5000}, {2000, 1ULL << 40}};
    EXPECT_EQ(parseIndex(indexBlock(9, keyframes).payload), keyframes);
    EXPECT_EQ(parseIndex(indexBlock(9, {}).payload), std::vector<KeyframePlace>());
    EXPECT_EQ(parseClosed(closedBlock(9, {1, 2, 3}).payload), (ClosedFacts{1, 2, 3}));
    EXPECT_EQ(parseRecovered(recoveredBlock(9, {4, 5}).payload), (RecoveredFacts{4, 5}));
    EXPECT_EQ(parseLost(lostBlock({1, 2, 3, 4}).payload), (LostFacts{1, 2, 3, 4}));
    EXPECT_EQ(parseTrimmed(trimmedBlock({6, 7}).payload), (TrimmedFacts{6, 7}));
}

TEST(ContainerBlocks, HaveOneLength) {
    expectOneLength(indexBlock(9, std::vector<KeyframePlace>(3)).payload, parseIndex);
    expectOneLength(closedBlock(9, {}).payload, parseClosed);
    expectOneLength(recoveredBlock(9, {}).payload, parseRecovered);
    expectOneLength(lostBlock({.blocks = 1}).payload, parseLost);
    expectOneLength(trimmedBlock({}).payload, parseTrimmed);
}

TEST(ContainerBlocks, AnIndexWithAnAbsurdCountIsRefused) {
    for (const std::uint64_t count : {~0ULL, 1ULL << 60, (1ULL << 60) + 1}) {
        std::vector<std::byte> payload = indexBlock(9, std::vector<KeyframePlace>(1)).payload;
        std::ranges::copy(std::as_bytes(std::span(&count, 1)), payload.begin());
        EXPECT_FALSE(parseIndex(payload)) << count;
    }
}

TEST(ContainerBlocks, LossesAddUp) {
    LostFacts facts;
    facts.add({BlockType::Events, 500, 500, std::vector<std::byte>(10)});
    facts.add({BlockType::Hash, 1000, 0, std::vector<std::byte>(8)});
    facts.add({BlockType::Events, 1000, 500, std::vector<std::byte>(20)});
    EXPECT_EQ(facts, (LostFacts{3, 38, 500, 1500}));
    const JournalBlock block = lostBlock(facts);
    EXPECT_EQ(block.type, BlockType::Lost);
    EXPECT_EQ(block.firstTick, 500U);
    EXPECT_EQ(block.ticks, 1000U);
}

TEST(ContainerBlocks, AnEndlessLossHasAsManyTicksAsABlockCan) {
    const JournalBlock block = lostBlock({1, 0, 5, kMaxTick});
    EXPECT_EQ(block.ticks, std::numeric_limits<std::uint32_t>::max());
    EXPECT_EQ(parseLost(block.payload)->endTick, kMaxTick);
}

TEST(ContainerBlocks, ThereIsNoLossOfNothing) { EXPECT_ASSERT((void)lostBlock({})); }

}  // namespace
}  // namespace tactooth
