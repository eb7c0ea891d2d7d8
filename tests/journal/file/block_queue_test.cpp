// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/block_queue.h"

#include <gtest/gtest.h>

#include "support/expect_assert.h"

namespace tactooth {
namespace {

JournalBlock blockOf(std::uint64_t tick, std::size_t bytes) {
    return {BlockType::Events, tick, 10, std::vector<std::byte>(bytes)};
}

TEST(BlockQueue, KeepsTheOrder) {
    BlockQueue queue({.blocks = 10, .bytes = 1000});
    for (const std::uint64_t tick : {0, 10, 20}) queue.push(blockOf(tick, 5));
    const std::vector<BlockQueue::Entry> entries = queue.takeAll();
    ASSERT_EQ(entries.size(), 3U);
    EXPECT_EQ(entries[1].block.firstTick, 10U);
    EXPECT_FALSE(entries[1].lostBefore);
    EXPECT_TRUE(queue.empty());
    EXPECT_TRUE(queue.takeAll().empty());
}

TEST(BlockQueue, HoldsSoManyBlocksAndBytes) {
    BlockQueue queue({.blocks = 3, .bytes = 100});
    queue.push(blockOf(0, 60));
    EXPECT_FALSE(queue.hasRoomFor(blockOf(10, 41)));
    EXPECT_TRUE(queue.hasRoomFor(blockOf(10, 40)));
    queue.push(blockOf(10, 1));
    queue.push(blockOf(20, 1));
    EXPECT_FALSE(queue.hasRoomFor(blockOf(30, 0)));
    EXPECT_ASSERT(queue.push(blockOf(30, 0)));
}

TEST(BlockQueue, AnEmptyOneTakesABlockOfAnySize) {
    BlockQueue queue({.blocks = 3, .bytes = 100});
    EXPECT_TRUE(queue.hasRoomFor(blockOf(0, 5000)));
    queue.push(blockOf(0, 5000));
    EXPECT_FALSE(queue.hasRoomFor(blockOf(10, 0)));
    (void)queue.takeAll();
    EXPECT_TRUE(queue.hasRoomFor(blockOf(10, 99)));
}

TEST(BlockQueue, TheNextBlockSaysWhatWasDropped) {
    BlockQueue queue({.blocks = 1, .bytes = 100});
    queue.push(blockOf(0, 5));
    queue.drop(blockOf(10, 7));
    queue.drop(blockOf(20, 8));
    EXPECT_FALSE(queue.takeAll()[0].lostBefore);
    queue.push(blockOf(30, 5));
    EXPECT_EQ(queue.takeAll()[0].lostBefore, (LostFacts{2, 15, 10, 30}));
    EXPECT_FALSE(queue.takeLost());
    queue.drop(blockOf(40, 1));
    EXPECT_EQ(queue.takeLost(), (LostFacts{1, 1, 40, 50}));
    EXPECT_FALSE(queue.takeLost());
}

}  // namespace
}  // namespace tactooth
