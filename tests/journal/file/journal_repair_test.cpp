// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/journal_repair.h"

#include <gtest/gtest.h>

#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "journal/file/journal_reader.h"
#include "journal/file/messages.h"
#include "journal/format/container_blocks.h"
#include "journal_samples.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using Bytes = std::vector<std::byte>;

Bytes contentOf(const std::filesystem::path& path) {
    const auto file = readFile(path);
    EXPECT_TRUE(file) << file.error().message();
    return {file->bytes().begin(), file->bytes().end()};
}

class JournalRepairTest : public testing::Test {
protected:
    JournalRepair repaired(std::span<const std::byte> bytes) {
        EXPECT_TRUE(writeFile(folder_ / "in", bytes));
        const auto repair = repairJournal(folder_ / "in", folder_ / "out");
        EXPECT_TRUE(repair) << repair.error().message();
        return *repair;
    }

    test::TemporaryFolder folder_;
};

TEST_F(JournalRepairTest, KeepsTheWholeBlocksByteForByte) {
    const std::vector<JournalBlock> blocks = test::sampleBlocks(51, 2);
    const Bytes bytes = test::journalBytes(blocks, true);
    const auto whole = JournalReader::parse(bytes, "sample");
    const BlockPlace& half = whole->blocks()[5];
    const JournalRepair repair = repaired(std::span(bytes).first(half.offset + 20));
    EXPECT_EQ(repair.blocks, 5U);
    EXPECT_EQ(repair.keptBytes, half.offset);
    EXPECT_EQ(repair.droppedBytes, 20U);
    EXPECT_FALSE(repair.hadEnd);

    const Bytes out = contentOf(folder_ / "out");
    EXPECT_TRUE(std::ranges::equal(std::span(out).first(half.offset), std::span(bytes).first(half.offset)));
    const auto journal = JournalReader::open(folder_ / "out");
    ASSERT_TRUE(journal);
    EXPECT_FALSE(journal->isComplete());
    EXPECT_TRUE(journal->isRecovered());
    EXPECT_FALSE(journal->cutOffAt());
    ASSERT_EQ(journal->blocks().size(), 6U);
    test::expectBlocks(*journal, std::span(blocks).first(5));
    const BlockPlace& end = journal->blocks().back();
    EXPECT_EQ(end.header.firstTick, journal->ticks()->end);
    EXPECT_EQ(parseRecovered(journal->payload(end).value()), (RecoveredFacts{half.offset, 20}));
}

TEST_F(JournalRepairTest, ARecordingWithoutBlocksGetsAnEnd) {
    const Bytes bytes = test::journalBytes({}, false);
    EXPECT_EQ(repaired(bytes).blocks, 0U);
    EXPECT_TRUE(JournalReader::open(folder_ / "out").value().isRecovered());
}

TEST_F(JournalRepairTest, CopiesWhatHasAnEnd) {
    Bytes bytes = test::journalBytes(test::sampleBlocks(52, 1), true);
    EXPECT_TRUE(repaired(bytes).hadEnd);
    EXPECT_EQ(contentOf(folder_ / "out"), bytes);
    const std::size_t end = bytes.size();
    bytes.resize(end + 7);
    const JournalRepair repair = repaired(bytes);
    EXPECT_TRUE(repair.hadEnd);
    EXPECT_EQ(repair.droppedBytes, 7U);
    bytes.resize(end);
    EXPECT_EQ(contentOf(folder_ / "out"), bytes);
}

TEST_F(JournalRepairTest, TwiceIsAsOnce) {
    const Bytes bytes = test::journalBytes(test::sampleBlocks(53, 1), false);
    (void)repaired(std::span(bytes).first(bytes.size() - 3));
    const Bytes once = contentOf(folder_ / "out");
    EXPECT_TRUE(repaired(once).hadEnd);
    EXPECT_EQ(contentOf(folder_ / "out"), once);
}

TEST_F(JournalRepairTest, InPlaceOfTheSameFile) {
    const Bytes bytes = test::journalBytes(test::sampleBlocks(54, 1), false);
    ASSERT_TRUE(writeFile(folder_ / "in", std::span(bytes).first(bytes.size() - 3)));
    ASSERT_TRUE(repairJournal(folder_ / "in", folder_ / "in"));
    EXPECT_TRUE(JournalReader::open(folder_ / "in").value().isRecovered());
}

TEST_F(JournalRepairTest, WritesNothingWhereItRefuses) {
    test::writeText(folder_ / "in", "no recording");
    test::writeText(folder_ / "out", "old");
    EXPECT_TRUE(repairJournal(folder_ / "in", folder_ / "out").error().contains(msg::kNoJournal));
    EXPECT_EQ(test::readText(folder_ / "out"), "old");
}

}  // namespace
}  // namespace tactooth
