// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/journal_trim.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/files/atomic_file.h"
#include "journal/file/attachment_reader.h"
#include "journal/file/messages.h"
#include "journal/format/container_blocks.h"
#include "journal_samples.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

constexpr std::uint64_t kSecond = 2 * test::kSampleTicks;

class JournalTrimTest : public testing::Test {
protected:
    JournalTrimTest() {
        const std::vector<std::byte> bytes = test::journalBytes(blocks_, true);
        EXPECT_TRUE(writeFile(folder_ / "in", std::span<const std::byte>(bytes)));
    }
    JournalTrim trimmed(std::uint64_t from, std::uint64_t to) {
        const auto trim = trimJournal(folder_ / "in", folder_ / "out", from, to);
        EXPECT_TRUE(trim) << trim.error().message();
        return *trim;
    }

    test::TemporaryFolder folder_;
    std::vector<JournalBlock> blocks_ = test::sampleBlocks(61, 5);
};

std::vector<std::uint64_t> ticksOf(const JournalReader& journal, BlockType type) {
    std::vector<std::uint64_t> ticks;
    for (const BlockPlace& block : journal.blocks()) {
        if (block.header.type == type) ticks.push_back(block.header.firstTick);
    }
    return ticks;
}

TEST_F(JournalTrimTest, BeginsAtTheKeyframeBefore) {
    const JournalTrim trim = trimmed(2 * kSecond + 50, 3 * kSecond + 10);
    EXPECT_EQ(trim.ticks, (TickRange{2 * kSecond, 3 * kSecond + test::kSampleTicks}));
    const auto journal = JournalReader::open(folder_ / "out");
    ASSERT_TRUE(journal) << journal.error().message();
    EXPECT_TRUE(journal->isComplete());
    EXPECT_EQ(journal->ticks(), trim.ticks);
    EXPECT_EQ(journal->headerJson(), test::kSampleHeader);
    using Ticks = std::vector<std::uint64_t>;
    EXPECT_EQ(ticksOf(*journal, BlockType::Keyframe), Ticks({2 * kSecond, 3 * kSecond}));
    EXPECT_EQ(ticksOf(*journal, BlockType::Hash), Ticks({2 * kSecond, 3 * kSecond}));
    EXPECT_EQ(ticksOf(*journal, BlockType::Events),
              Ticks({2 * kSecond, 2 * kSecond + test::kSampleTicks, 3 * kSecond}));
    EXPECT_EQ(journal->blocks()[0].header.type, BlockType::Trimmed);
    EXPECT_EQ(parseTrimmed(journal->payload(journal->blocks()[0]).value()),
              (TrimmedFacts{2 * kSecond + 50, 3 * kSecond + 10}));
}

TEST_F(JournalTrimTest, KeepsAttachmentsUnknownTypesAndPayloads) {
    (void)trimmed(kSecond, kSecond + 1);
    const auto journal = JournalReader::open(folder_ / "out");
    ASSERT_TRUE(journal);
    EXPECT_TRUE(readAttachment(*journal, "fnv1a:0123456789abcdef"));
    int unknown = 0;
    for (const BlockPlace& place : journal->blocks()) {
        unknown += !isKnown(place.header.type);
        if (isOfContainer(place.header.type)) continue;
        const auto same = [&](const JournalBlock& block) {
            return block.type == place.header.type && block.firstTick == place.header.firstTick &&
                   block.payload == journal->payload(place).value();
        };
        EXPECT_TRUE(std::ranges::any_of(blocks_, same));
    }
    EXPECT_EQ(unknown, 1);
}

TEST_F(JournalTrimTest, TheWholeRecordingKeepsEachBlock) {
    EXPECT_EQ(trimmed(0, 5 * kSecond).blocks, blocks_.size());
    const auto journal = JournalReader::open(folder_ / "out");
    EXPECT_EQ(journal->blocks().size(), blocks_.size() + 3);
}

TEST_F(JournalTrimTest, APartOfAPartSaysWhatItIs) {
    (void)trimmed(kSecond, 4 * kSecond);
    const auto again = trimJournal(folder_ / "out", folder_ / "again", 2 * kSecond, 3 * kSecond);
    ASSERT_TRUE(again);
    const auto journal = JournalReader::open(folder_ / "again");
    EXPECT_EQ(ticksOf(*journal, BlockType::Trimmed), std::vector<std::uint64_t>({2 * kSecond}));
    EXPECT_EQ(ticksOf(*journal, BlockType::Closed).size(), 1U);
}

TEST_F(JournalTrimTest, RefusesTicksOfWhichNothingWasRecorded) {
    test::writeText(folder_ / "out", "old");
    for (const auto& [from, to] : std::vector<TickRange>{{5 * kSecond, 9 * kSecond}, {7, 7}, {9999, kMaxTick}})
        EXPECT_TRUE(trimJournal(folder_ / "in", folder_ / "out", from, to).error().contains(msg::kJournalTrimEmpty));
    EXPECT_EQ(test::readText(folder_ / "out"), "old");
}

}  // namespace
}  // namespace tactooth
