// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/process/shared_slots.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <memory>
#include <new>
#include <thread>

namespace tactooth {
namespace {

/// A value whose words are all equal, so that a mixture of two values shows.
struct Block {
    std::array<std::uint64_t, 24> words{};

    static Block of(std::uint64_t number) {
        Block block;
        block.words.fill(number);
        return block;
    }
    [[nodiscard]] bool isWhole() const {
        return std::ranges::all_of(words, [this](std::uint64_t word) { return word == words[0]; });
    }
};

TEST(SharedSlots, HandsOnTheNewestValueOnce) {
    SharedSlots<Block> slots;
    SlotWriter<Block> writer(slots);
    SlotReader<Block> reader(slots);
    EXPECT_FALSE(reader.refresh());
    EXPECT_EQ(reader.value().words[0], 0U);
    for (std::uint64_t i = 1; i < 100; ++i) {
        writer.write(Block::of(i));
        if (i % 7 != 0) continue;
        ASSERT_TRUE(reader.refresh());
        EXPECT_EQ(reader.value().words[0], i);
        EXPECT_FALSE(reader.refresh());
        EXPECT_EQ(reader.value().words[0], i);
    }
}

TEST(SharedSlots, NeverShowsAMixtureOfTwoValuesNorAnOlderOne) {
    SharedSlots<Block> slots;
    std::jthread writing([&slots](const std::stop_token& stop) {
        SlotWriter<Block> writer(slots);
        for (std::uint64_t i = 1; !stop.stop_requested(); ++i) writer.write(Block::of(i));
    });
    SlotReader<Block> reader(slots);
    std::uint64_t last = 0;
    for (int seen = 0; seen < 20'000;) {
        if (!reader.refresh()) continue;
        ++seen;
        ASSERT_TRUE(reader.value().isWhole());
        ASSERT_GT(reader.value().words[0], last);
        last = reader.value().words[0];
    }
}

/// Memory that this process shares with its children.
template <class T>
struct Shared {
    Shared() : place(new (mmap(nullptr, sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) T()) {}
    ~Shared() { munmap(place, sizeof(T)); }
    T* place;
};

TEST(SharedSlots, AWriterThatIsKilledAtAnyMomentLeavesAWholeValue) {
    for (int round = 0; round < 20; ++round) {
        const Shared<SharedSlots<Block>> shared;
        const pid_t child = fork();
        if (child == 0) {
            SlotWriter<Block> writer(*shared.place);
            for (std::uint64_t i = 1;; ++i) writer.write(Block::of(i));
        }
        SlotReader<Block> reader(*shared.place);
        for (int seen = 0; seen < 10 + round;) seen += reader.refresh() ? 1 : 0;
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        (void)reader.refresh();
        EXPECT_TRUE(reader.value().isWhole());
        EXPECT_FALSE(reader.refresh());
    }
}

TEST(SharedSlots, NonsenseOfTheOtherProcessIsNotFollowed) {
    SharedSlots<Block> slots;
    SlotReader<Block> reader(slots);
    SlotWriter<Block> writer(slots);
    writer.write(Block::of(7));
    ASSERT_TRUE(reader.refresh());
    std::fill_n(reinterpret_cast<unsigned char*>(&slots), sizeof slots, 0xFF);  // slot 3, which there is not, is fresh
    EXPECT_FALSE(reader.refresh());
    EXPECT_EQ(reader.value().words[0], 7U);
    std::fill_n(reinterpret_cast<unsigned char*>(&slots), sizeof slots, 0xFF);
    for (std::uint64_t i = 8; i < 20; ++i) writer.write(Block::of(i));  // writes into no other memory
    ASSERT_TRUE(reader.refresh());
    EXPECT_EQ(reader.value().words[0], 19U);
}

}  // namespace
}  // namespace tactooth
