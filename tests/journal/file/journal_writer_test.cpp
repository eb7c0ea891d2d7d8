// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/journal_writer.h"

#include <gtest/gtest.h>

#include <cerrno>

#include "fake_journal_file.h"
#include "geometry/util/messages.h"
#include "journal/file/journal_reader.h"
#include "journal/file/messages.h"
#include "journal_samples.h"
#include "support/expect_assert.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using test::FakeDisk;
using Options = JournalWriter::Options;

constexpr auto kNever = std::chrono::hours(10);

std::unique_ptr<JournalWriter> writerOn(const std::shared_ptr<FakeDisk>& disk, const Options& options = {}) {
    auto writer = JournalWriter::start(test::fileOn(disk), "sample", test::kSampleHeader, options);
    EXPECT_TRUE(writer) << writer.error().message();
    return std::move(*writer);
}

JournalBlock noteAt(std::uint64_t tick, std::uint32_t ticks = 10) { return {BlockType::Note, tick, ticks, {}}; }

std::vector<BlockType> typesIn(const std::vector<std::byte>& bytes) {
    const auto journal = JournalReader::parse(bytes, "sample");
    EXPECT_TRUE(journal) << journal.error().message();
    std::vector<BlockType> types;
    for (const BlockPlace& block : journal->blocks()) types.push_back(block.header.type);
    return types;
}

TEST(JournalWriter, RecordsIntoAFile) {
    const test::TemporaryFolder folder;
    const std::vector<JournalBlock> blocks = test::sampleBlocks(71, 20);
    auto writer = JournalWriter::create(folder / "a.ttsession", test::kSampleHeader);
    ASSERT_TRUE(writer) << writer.error().message();
    for (const JournalBlock& block : blocks) EXPECT_TRUE((*writer)->append(block));
    const auto closed = (*writer)->close(blocks.back().firstTick);
    ASSERT_TRUE(closed) << closed.error().message();
    EXPECT_EQ((*writer)->lostBlocks(), 0U);
    const auto journal = JournalReader::open(folder / "a.ttsession");
    ASSERT_TRUE(journal) << journal.error().message();
    EXPECT_TRUE(journal->isComplete());
    EXPECT_EQ(journal->bytes(), (*writer)->bytes());
    test::expectBlocks(*journal, blocks);
}

TEST(JournalWriter, SyncsAtLeastOnceASecond) {
    EXPECT_LE(Options().syncPeriod, std::chrono::seconds(1));
    const auto disk = std::make_shared<FakeDisk>();
    const auto writer = writerOn(disk, {.syncPeriod = std::chrono::milliseconds(1)});
    for (int i = 0; i < 5; ++i) {
        const int before = disk->syncs();
        EXPECT_TRUE(writer->append(noteAt(i)));
        ASSERT_TRUE(disk->waitForSyncs(before + 1)) << "without any call";
    }
}

TEST(JournalWriter, SyncsNoMoreOftenThanItHasTo) {
    const auto disk = std::make_shared<FakeDisk>();
    const auto writer = writerOn(disk, {.syncPeriod = kNever});
    for (int i = 0; i < 100; ++i) EXPECT_TRUE(writer->append(noteAt(i)));
    EXPECT_TRUE(writer->flush());
    EXPECT_TRUE(writer->flush());
    EXPECT_EQ(disk->syncs(), 2) << "of the header and of the first flush";
}

TEST(JournalWriter, AfterAFlushAllIsOnTheDisk) {
    const auto disk = std::make_shared<FakeDisk>();
    const auto writer = writerOn(disk, {.syncPeriod = kNever});
    for (std::size_t i = 1; i < 200; ++i) {
        EXPECT_TRUE(writer->append(noteAt(i)));
        ASSERT_TRUE(writer->flush());
        ASSERT_EQ(typesIn(disk->syncedBytes()).size(), i);
    }
}

TEST(JournalWriter, WithoutAnEndTheFileIsAsAfterACrash) {
    const auto disk = std::make_shared<FakeDisk>();
    const std::vector<JournalBlock> blocks = test::sampleBlocks(72, 3);
    {
        const auto writer = writerOn(disk);
        for (const JournalBlock& block : blocks) EXPECT_TRUE(writer->append(block));
    }
    EXPECT_EQ(disk->syncedBytes(), test::journalBytes(blocks, false));
}

TEST(JournalWriter, AFullQueueIsCountedAndSaidInTheFile) {
    const auto disk = std::make_shared<FakeDisk>();
    const auto writer = writerOn(disk, {.queue = {.blocks = 3, .bytes = 1000}});
    disk->hold();
    EXPECT_TRUE(writer->append(noteAt(0)));
    ASSERT_TRUE(disk->waitUntilHeld());
    for (int i = 1; i <= 3; ++i) EXPECT_TRUE(writer->append(noteAt(10 * i)));
    EXPECT_FALSE(writer->append(noteAt(40)));
    EXPECT_FALSE(writer->append(noteAt(50)));
    EXPECT_EQ(writer->lostBlocks(), 2U);
    disk->release();
    EXPECT_TRUE(writer->flush());
    EXPECT_TRUE(writer->append(noteAt(60)));
    EXPECT_TRUE(writer->close(70));

    using enum BlockType;
    const std::vector<std::byte> bytes = disk->bytes();
    EXPECT_EQ(typesIn(bytes), std::vector<BlockType>({Note, Note, Note, Note, Lost, Note, Index, Closed}));
    const auto journal = JournalReader::parse(bytes, "sample");
    EXPECT_EQ(parseLost(journal->payload(journal->blocks()[4]).value()), (LostFacts{2, 0, 40, 60}));
    EXPECT_EQ(parseClosed(journal->payload(journal->blocks()[7]).value())->lostBlocks, 2U);
    EXPECT_FALSE(writer->fault());
}

TEST(JournalWriter, WhatIsLostLastIsSaidAtTheEnd) {
    const auto disk = std::make_shared<FakeDisk>();
    const auto writer = writerOn(disk, {.queue = {.blocks = 1, .bytes = 1000}});
    disk->hold();
    EXPECT_TRUE(writer->append(noteAt(0)));
    ASSERT_TRUE(disk->waitUntilHeld());
    EXPECT_TRUE(writer->append(noteAt(10)));
    EXPECT_FALSE(writer->append(noteAt(20)));
    disk->release();
    EXPECT_TRUE(writer->close(30));
    using enum BlockType;
    EXPECT_EQ(typesIn(disk->bytes()), std::vector<BlockType>({Note, Note, Lost, Index, Closed}));
}

TEST(JournalWriter, WaitsForRoomOnRequest) {
    const auto disk = std::make_shared<FakeDisk>();
    const auto writer = writerOn(disk, {.queue = {.blocks = 2, .bytes = 1000}});
    for (int i = 0; i < 500; ++i) EXPECT_TRUE(writer->appendWhenRoom(noteAt(i)));
    EXPECT_TRUE(writer->close(500));
    EXPECT_EQ(writer->lostBlocks(), 0U);
    EXPECT_EQ(typesIn(disk->bytes()).size(), 502U);
}

TEST(JournalWriter, NoOneWaitsForTheRoomOfAStoppedRecording) {
    const auto disk = std::make_shared<FakeDisk>(FakeDisk::Faults{.capacity = 500});
    const auto writer = writerOn(disk, {.queue = {.blocks = 2, .bytes = 1000}});
    int taken = 0;
    while (writer->appendWhenRoom(noteAt(taken))) ++taken;
    EXPECT_TRUE(writer->fault());
    EXPECT_GE(taken, 5);
}

TEST(JournalWriter, AFullDiskIsOneSentenceAndTheSessionGoesOn) {
    const auto disk = std::make_shared<FakeDisk>(FakeDisk::Faults{.capacity = 1000});
    const auto writer = writerOn(disk);
    std::uint64_t appended = 0;
    while (writer->append(noteAt(appended))) {
        ++appended;
        (void)writer->flush();
    }
    ASSERT_TRUE(writer->fault());
    EXPECT_EQ(writer->fault()->in(Language::English),
              "sample: recording stopped (No space left on device); the session goes on, and what was recorded before "
              "is kept.");
    const std::size_t kept = typesIn(disk->bytes()).size();
    EXPECT_EQ(writer->lostBlocks(), appended + 1 - kept);
    EXPECT_FALSE(writer->append(noteAt(0)));
    EXPECT_EQ(writer->lostBlocks(), appended + 2 - kept);
    EXPECT_TRUE(writer->flush().error().contains(msg::kNoSpace));
    EXPECT_TRUE(writer->close(0).error().contains(msg::kNoSpace));
    EXPECT_EQ(typesIn(disk->bytes()).size(), kept);
}

TEST(JournalWriter, AFailingDiskIsReportedByTheFlush) {
    for (const int failing : {2, 3, 7}) {
        const auto disk = std::make_shared<FakeDisk>(FakeDisk::Faults{.failingSync = failing, .syncFailure = EIO});
        const auto writer = writerOn(disk, {.syncPeriod = kNever});
        int flushed = 0;
        while (writer->append(noteAt(flushed)) && writer->flush()) ++flushed;
        EXPECT_EQ(flushed, failing - 2);
        EXPECT_TRUE(writer->fault()->contains(msg::kInputOutputError));
        EXPECT_GE(typesIn(disk->syncedBytes()).size(), static_cast<std::size_t>(flushed));
    }
}

TEST(JournalWriter, ADeletedFolderIsNoticed) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directory(folder / "in");
    auto writer = JournalWriter::create(folder / "in/a.ttsession", "{}");
    ASSERT_TRUE(writer);
    EXPECT_TRUE((*writer)->append(noteAt(0)));
    EXPECT_TRUE((*writer)->flush());
    std::filesystem::remove_all(folder / "in");
    EXPECT_TRUE((*writer)->append(noteAt(10)));
    EXPECT_FALSE((*writer)->flush());
    EXPECT_EQ((*writer)->fault()->id(), msg::kJournalDeleted.id);
}

TEST(JournalWriter, LeavesNoFileThatItCannotBegin) {
    const test::TemporaryFolder folder;
    EXPECT_FALSE(JournalWriter::create(folder / "none/a.ttsession", "{}"));
    EXPECT_TRUE(JournalWriter::create(folder / "a.ttsession", "{}"));
    EXPECT_TRUE(JournalWriter::create(folder / "a.ttsession", "{}").error().contains(msg::kJournalExists));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(JournalWriter, ManyThreadsMayAppend) {
    const auto disk = std::make_shared<FakeDisk>();
    const auto writer = writerOn(disk);
    const auto appendMany = [&] {
        for (int i = 0; i < 200; ++i) {
            EXPECT_TRUE(writer->appendWhenRoom(noteAt(i)));
            if (i % 50 == 0) {
                EXPECT_TRUE(writer->flush());
            }
        }
    };
    {
        std::vector<std::jthread> threads(4);
        for (std::jthread& thread : threads) thread = std::jthread(appendMany);
    }
    EXPECT_TRUE(writer->close(200));
    EXPECT_EQ(typesIn(disk->bytes()).size(), 4 * 200 + 2U);
}

TEST(JournalWriter, TakesNoBlocksOfTheContainer) {
    const auto writer = writerOn(std::make_shared<FakeDisk>());
    EXPECT_ASSERT((void)writer->append({BlockType::Closed, 0, 0, {}}));
}

}  // namespace
}  // namespace tactooth
