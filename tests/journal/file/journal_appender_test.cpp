// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Disks that are full, interrupt, write little at once or fail: no half block counts as a whole one.
#include "journal/file/journal_appender.h"

#include <gtest/gtest.h>

#include <cerrno>

#include "fake_journal_file.h"
#include "geometry/util/messages.h"
#include "journal/file/journal_reader.h"
#include "journal/file/messages.h"
#include "journal_samples.h"
#include "support/sanitizer.h"

namespace tactooth {
namespace {

using test::FakeDisk;

Expected<JournalAppender> beginOn(const std::shared_ptr<FakeDisk>& disk) {
    return JournalAppender::begin(test::fileOn(disk), "sample", test::kSampleHeader);
}

/// Appends the blocks up to the first that is refused; returns how many were written.
std::size_t appendAll(JournalAppender& appender, const std::vector<JournalBlock>& blocks) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (!appender.append(blocks[i])) return i;
    }
    return blocks.size();
}

TEST(JournalAppender, AFullDiskLeavesWholeBlocksWhereverItEnds) {
    const std::vector<JournalBlock> blocks = test::sampleBlocks(11, 1);
    const std::size_t whole = test::journalBytes(blocks, false).size();
    const std::size_t header = test::journalBytes({}, false).size();
    for (std::size_t capacity = header; capacity < whole; ++capacity) {
        const auto disk = std::make_shared<FakeDisk>(FakeDisk::Faults{.capacity = capacity});
        auto appender = beginOn(disk);
        ASSERT_TRUE(appender);
        const std::size_t written = appendAll(*appender, blocks);
        ASSERT_LT(written, blocks.size());
        ASSERT_TRUE(appender->fault());
        EXPECT_TRUE(appender->fault()->contains(msg::kJournalStopped) && appender->fault()->contains(msg::kNoSpace));
        const std::vector<std::byte> bytes = disk->bytes();
        const auto journal = JournalReader::parse(bytes, "sample");
        ASSERT_TRUE(journal) << journal.error().message();
        ASSERT_EQ(journal->blocks().size(), written) << capacity;
        test::expectBlocks(*journal, std::span(blocks).first(written));
        EXPECT_EQ(journal->scan().end, appender->bytes());
    }
}

TEST(JournalAppender, WritesNothingAfterAFailure) {
    const auto disk = std::make_shared<FakeDisk>(FakeDisk::Faults{.capacity = 300});
    const std::vector<JournalBlock> blocks = test::sampleBlocks(12, 2);
    auto appender = beginOn(disk);
    (void)appendAll(*appender, blocks);
    const std::vector<std::byte> before = disk->bytes();
    EXPECT_FALSE(appender->append({BlockType::Note, 0, 0, {}}));
    EXPECT_FALSE(appender->appendLost({.blocks = 1}));
    EXPECT_FALSE(appender->sync());
    EXPECT_FALSE(appender->end(0));
    EXPECT_EQ(disk->bytes(), before);
}

TEST(JournalAppender, ShortAndInterruptedWritesChangeNoByte) {
    const std::vector<JournalBlock> blocks = test::sampleBlocks(13, 2);
    const std::vector<std::byte> wanted = test::journalBytes(blocks, true);
    for (const auto& faults :
         {FakeDisk::Faults{.bytesAtOnce = 1}, FakeDisk::Faults{.bytesAtOnce = 7},
          FakeDisk::Faults{.bytesAtOnce = 50, .interruptEvery = 2}, FakeDisk::Faults{.interruptEvery = 3}}) {
        const auto disk = std::make_shared<FakeDisk>(faults);
        auto appender = beginOn(disk);
        ASSERT_TRUE(appender);
        EXPECT_EQ(appendAll(*appender, blocks), blocks.size());
        EXPECT_TRUE(appender->end(blocks.back().firstTick));
        EXPECT_EQ(disk->bytes(), wanted);
        EXPECT_EQ(disk->syncedBytes(), wanted);
    }
}

TEST(JournalAppender, EndlessInterruptionsAreAFailure) {
    const auto disk = std::make_shared<FakeDisk>(FakeDisk::Faults{.interruptEvery = 1});
    const auto appender = beginOn(disk);
    ASSERT_FALSE(appender);
    EXPECT_TRUE(appender.error().contains(msg::kOutputNotWritten));
}

TEST(JournalAppender, AFailedSyncStopsItForGood) {
    for (const int failure : {EIO, ENOSPC, EDQUOT, EROFS}) {
        const auto disk = std::make_shared<FakeDisk>(FakeDisk::Faults{.failingSync = 2, .syncFailure = failure});
        auto appender = beginOn(disk);
        ASSERT_TRUE(appender) << "the first sync is that of the header";
        EXPECT_TRUE(appender->append({BlockType::Note, 0, 0, {}}));
        EXPECT_FALSE(appender->sync());
        ASSERT_TRUE(appender->fault());
        EXPECT_TRUE(appender->fault()->contains(msg::kJournalStopped));
        EXPECT_FALSE(appender->append({BlockType::Note, 0, 0, {}}));
        EXPECT_FALSE(appender->sync());
        EXPECT_EQ(disk->syncs(), 2);
    }
}

TEST(JournalAppender, ADeletedFileHasASentenceOfItsOwn) {
    const auto disk = std::make_shared<FakeDisk>(FakeDisk::Faults{.failingSync = 2, .syncFailure = ENOENT});
    auto appender = beginOn(disk);
    (void)appender->append({BlockType::Note, 0, 0, {}});
    EXPECT_FALSE(appender->sync());
    EXPECT_EQ(appender->fault()->id(), msg::kJournalDeleted.id);
}

TEST(JournalAppender, DoesNotBeginWithoutAHeader) {
    for (const std::size_t capacity : {0U, 1U, 19U}) {
        const auto appender = beginOn(std::make_shared<FakeDisk>(FakeDisk::Faults{.capacity = capacity}));
        ASSERT_FALSE(appender);
        EXPECT_TRUE(appender.error().contains(msg::kNoSpace)) << appender.error().message();
    }
    EXPECT_FALSE(beginOn(std::make_shared<FakeDisk>(FakeDisk::Faults{.failingSync = 1, .syncFailure = EIO})));
    const auto taken = beginOn(std::make_shared<FakeDisk>(FakeDisk::Faults{.publishFailure = EEXIST}));
    EXPECT_TRUE(taken.error().contains(msg::kJournalExists));
}

TEST(JournalAppender, TheEndStatesWhereTheKeyframesAre) {
    const std::vector<JournalBlock> blocks = test::sampleBlocks(14, 5);
    const std::vector<std::byte> bytes = test::journalBytes(blocks, true);
    const auto journal = JournalReader::parse(bytes, "sample");
    ASSERT_TRUE(journal && journal->isComplete());
    const std::span<const BlockPlace> places = journal->blocks();
    ASSERT_EQ(places.size(), blocks.size() + 2);
    std::vector<KeyframePlace> keyframes;
    for (const BlockPlace& place : places) {
        if (place.header.type == BlockType::Keyframe) keyframes.push_back({place.header.firstTick, place.offset});
    }
    EXPECT_EQ(keyframes.size(), 5U);
    const BlockPlace& index = places[blocks.size()];
    EXPECT_EQ(parseIndex(journal->payload(index).value()), keyframes);
    EXPECT_EQ(parseClosed(journal->payload(places.back()).value()), (ClosedFacts{index.offset, blocks.size() + 1, 0}));
    EXPECT_EQ(bytes.size() - places.back().offset, 60U) << "as documented";
}

TEST(JournalAppender, ABlockThatIsTooLargeIsCountedAsLost) {
    const auto disk = std::make_shared<FakeDisk>();
    auto appender = beginOn(disk);
    EXPECT_FALSE(appender->append({BlockType::Keyframe, 500, 0, std::vector<std::byte>(kMaxRawBytes + 1)}));
    EXPECT_FALSE(appender->fault());
    EXPECT_TRUE(appender->append({BlockType::Note, 600, 0, {}}));
    EXPECT_TRUE(appender->end(600));
    const std::vector<std::byte> bytes = disk->bytes();
    const auto journal = JournalReader::parse(bytes, "sample");
    ASSERT_TRUE(journal);
    EXPECT_EQ(parseLost(journal->payload(journal->blocks()[0]).value()), (LostFacts{1, kMaxRawBytes + 1ULL, 500, 500}));
    EXPECT_EQ(parseClosed(journal->payload(journal->blocks().back()).value())->lostBlocks, 1U);
}

TEST(JournalAppender, HasAMostOfBlocksThatReadersTake) {
    if (test::isSanitized()) GTEST_SKIP() << "a million blocks";
    const auto disk = std::make_shared<FakeDisk>();
    auto appender = beginOn(disk);
    for (std::size_t i = 0; i < kMaxBlocks; ++i) ASSERT_TRUE(appender->append({BlockType::Note, i, 0, {}}));
    EXPECT_FALSE(appender->append({BlockType::Note, 0, 0, {}}));
    EXPECT_EQ(appender->fault()->id(), msg::kJournalFull.id);
    std::vector<std::byte> bytes = disk->bytes();
    const auto journal = JournalReader::parse(bytes, "sample");
    ASSERT_TRUE(journal);
    EXPECT_EQ(journal->blocks().size(), kMaxBlocks);

    BlockEncoder encoder(journal->scan().lastCrc());
    const auto more = encoder.encode({BlockType::Note, 0, 0, {}});
    bytes.insert(bytes.end(), more->begin(), more->end());
    EXPECT_TRUE(JournalReader::parse(bytes, "sample").error().contains(msg::kJournalTooManyBlocks));
}

}  // namespace
}  // namespace tactooth
