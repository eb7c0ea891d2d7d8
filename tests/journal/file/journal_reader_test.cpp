// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/journal_reader.h"

#include <gtest/gtest.h>

#include "geometry/files/atomic_file.h"
#include "geometry/util/byte_text.h"
#include "geometry/util/messages.h"
#include "journal/file/messages.h"
#include "journal/format/block_encoder.h"
#include "journal/format/file_header.h"
#include "journal_samples.h"
#include "resealed_journal.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using Bytes = std::vector<std::byte>;

TEST(JournalReader, GivesWhatWasWritten) {
    const std::vector<JournalBlock> blocks = test::sampleBlocks(21, 4);
    const Bytes bytes = test::journalBytes(blocks, true);
    const auto journal = JournalReader::parse(bytes, "sample");
    ASSERT_TRUE(journal) << journal.error().message();
    EXPECT_EQ(journal->headerJson(), test::kSampleHeader);
    test::expectBlocks(*journal, blocks);
    EXPECT_TRUE(journal->isComplete());
    EXPECT_FALSE(journal->isRecovered());
    EXPECT_FALSE(journal->cutOffAt());
    EXPECT_EQ(journal->ticks(), (TickRange{0, 8 * test::kSampleTicks}));
}

TEST(JournalReader, ReadsTheSameFromAFile) {
    const test::TemporaryFolder folder;
    const std::vector<JournalBlock> blocks = test::sampleBlocks(22, 4);
    const Bytes bytes = test::journalBytes(blocks, true);
    ASSERT_TRUE(writeFile(folder / "a.ttsession", std::span<const std::byte>(bytes)));
    const auto journal = JournalReader::open(folder / "a.ttsession");
    ASSERT_TRUE(journal) << journal.error().message();
    test::expectBlocks(*journal, blocks);
    EXPECT_EQ(journal->bytes(), bytes.size());
    EXPECT_EQ(journal->name(), (folder / "a.ttsession").string());
}

TEST(JournalReader, CutAtAnyByteItOpensToTheLastWholeBlock) {
    const std::vector<JournalBlock> blocks = test::sampleBlocks(23, 2);
    const Bytes bytes = test::journalBytes(blocks, true);
    const std::size_t header = kHeaderFrameBytes + test::kSampleHeader.size();
    const auto whole = JournalReader::parse(bytes, "sample");
    ASSERT_TRUE(whole);
    for (std::size_t size = 0; size <= bytes.size(); ++size) {
        const auto journal = JournalReader::parse(std::span(bytes).first(size), "sample");
        ASSERT_EQ(journal.has_value(), size >= header) << size;
        if (!journal) {
            EXPECT_TRUE(journal.error().contains(size == 0 ? msg::kNoJournal : msg::kJournalHeadDamaged));
            continue;
        }
        std::size_t wanted = 0;
        while (wanted < whole->blocks().size() && whole->blocks()[wanted].end() <= size) ++wanted;
        ASSERT_EQ(journal->blocks().size(), wanted) << size;
        const std::uint64_t end = wanted == 0 ? header : whole->blocks()[wanted - 1].end();
        EXPECT_EQ(journal->cutOffAt(), end == size ? std::nullopt : std::optional(end)) << size;
        EXPECT_EQ(journal->isComplete(), size == bytes.size());
        test::expectBlocks(*journal, std::span(blocks).first(std::min(wanted, blocks.size())));
    }
}

TEST(JournalReader, AnyFlippedBitEndsTheChainThere) {
    const Bytes bytes = test::journalBytes(test::sampleBlocks(24, 1), true);
    const auto whole = JournalReader::parse(bytes, "sample");
    ASSERT_TRUE(whole);
    const std::size_t header = whole->blocks()[0].offset;
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        Bytes damaged = bytes;
        damaged[bit / 8] ^= std::byte{1} << (bit % 8);
        const auto journal = JournalReader::parse(damaged, "sample");
        ASSERT_EQ(journal.has_value(), bit / 8 >= header) << bit;
        if (!journal) continue;
        std::size_t intact = 0;
        while (whole->blocks()[intact].end() <= bit / 8) ++intact;
        EXPECT_EQ(journal->blocks().size(), intact) << bit;
        EXPECT_EQ(journal->cutOffAt(), whole->blocks()[intact].offset);
    }
}

TEST(JournalReader, ZerosBehindTheLastBlockAreCutOff) {
    Bytes bytes = test::journalBytes(test::sampleBlocks(25, 1), false);
    const std::size_t end = bytes.size();
    bytes.resize(end + 10000);  // as some file systems leave a file after a power failure
    const auto journal = JournalReader::parse(bytes, "sample");
    ASSERT_TRUE(journal);
    EXPECT_EQ(journal->cutOffAt(), end);
    EXPECT_FALSE(journal->isComplete());
}

TEST(JournalReader, ABlockThatIsMissingOrOfAnotherFileEndsTheChain) {
    const std::vector<JournalBlock> blocks = test::sampleBlocks(26, 2);
    const Bytes bytes = test::journalBytes(blocks, true), other = test::journalBytes(blocks, true, "{}");
    const auto whole = JournalReader::parse(bytes, "sample"), second = JournalReader::parse(other, "other");
    ASSERT_TRUE(whole && second);
    const BlockPlace& missing = whole->blocks()[3];
    Bytes shorter = bytes;
    shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(missing.offset),
                  shorter.begin() + static_cast<std::ptrdiff_t>(missing.end()));
    EXPECT_EQ(JournalReader::parse(shorter, "sample").value().blocks().size(), 3U);

    Bytes mixed(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(missing.offset));
    mixed.insert(mixed.end(), other.begin() + static_cast<std::ptrdiff_t>(second->blocks()[3].offset), other.end());
    EXPECT_EQ(JournalReader::parse(mixed, "sample").value().blocks().size(), 3U);
}

TEST(JournalReader, NothingIsReadBehindTheEnd) {
    Bytes bytes = test::journalBytes(test::sampleBlocks(27, 1), true);
    const auto whole = JournalReader::parse(bytes, "sample");
    const std::size_t count = whole->blocks().size(), end = bytes.size();
    BlockEncoder encoder(whole->scan().lastCrc());
    const auto more = encoder.encode({BlockType::Note, 0, 0, {}});
    bytes.insert(bytes.end(), more->begin(), more->end());
    const auto journal = JournalReader::parse(bytes, "sample");
    EXPECT_TRUE(journal->isComplete());
    EXPECT_EQ(journal->blocks().size(), count);
    EXPECT_EQ(journal->cutOffAt(), end);
}

TEST(JournalReader, RefusesAnotherVersionWithOneSentence) {
    Bytes bytes = test::journalBytes({}, true);
    bytes[8] = std::byte{2};
    const auto journal = JournalReader::parse(bytes, "a.ttsession");
    ASSERT_FALSE(journal);
    EXPECT_EQ(journal.error().message(),
              "a.ttsession: the recording has format version 2, but this program reads version 1; open it with the "
              "version of Tactooth that recorded it.");
}

TEST(JournalReader, RefusesWhatIsNoRecording) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "a", "solid tooth");
    test::writeText(folder / "empty", "");
    EXPECT_TRUE(JournalReader::open(folder / "a").error().contains(msg::kNoJournal));
    EXPECT_TRUE(JournalReader::open(folder / "empty").error().contains(msg::kNoJournal));
    EXPECT_TRUE(JournalReader::open(folder / "none").error().contains(msg::kFileMissing));
    EXPECT_TRUE(JournalReader::open(folder.path()).error().contains(msg::kFileIsFolder));
}

TEST(JournalReader, ABlockThatHasChangedSinceIsRefused) {
    const test::TemporaryFolder folder;
    Bytes bytes = test::journalBytes(test::sampleBlocks(28, 1), true);
    ASSERT_TRUE(writeFile(folder / "a", std::span<const std::byte>(bytes)));
    const auto journal = JournalReader::open(folder / "a");
    ASSERT_TRUE(journal);
    const BlockPlace& block = journal->blocks()[1];
    bytes[block.offset + kBlockHeaderBytes] ^= std::byte{1};
    std::fstream file(folder / "a", std::ios::in | std::ios::out | std::ios::binary);
    file << asText(bytes);
    file.close();
    EXPECT_TRUE(journal->payload(block).error().contains(msg::kJournalBlockUnreadable));
    std::filesystem::resize_file(folder / "a", block.offset + kBlockHeaderBytes + 1);
    EXPECT_TRUE(journal->payload(block).error().contains(msg::kJournalBlockUnreadable));
}

TEST(JournalReader, ABlockThatDoesNotUnpackIsRefused) {
    Bytes bytes = test::journalBytes(test::sampleBlocks(29, 1), true);
    const std::uint64_t events = JournalReader::parse(bytes, "sample").value().blocks()[1].offset;
    bytes[events + kBlockHeaderBytes] ^= std::byte{0xFF};  // the magic of zstd
    test::reseal(bytes);
    const auto journal = JournalReader::parse(bytes, "sample");
    ASSERT_TRUE(journal->isComplete());
    ASSERT_TRUE(journal->blocks()[1].header.isCompressed());
    EXPECT_TRUE(journal->payload(journal->blocks()[1]).error().contains(msg::kJournalBlockUnreadable));
}

TEST(JournalReader, FindsBlocksByTick) {
    const Bytes bytes = test::journalBytes(test::sampleBlocks(30, 3), true);
    const auto journal = JournalReader::parse(bytes, "sample");
    ASSERT_TRUE(journal);
    constexpr std::uint64_t kSecond = 2 * test::kSampleTicks;
    for (std::uint64_t tick = 0; tick < 3 * kSecond; ++tick) {
        const BlockPlace* const events = journal->blockAt(BlockType::Events, tick);
        ASSERT_NE(events, nullptr);
        EXPECT_EQ(events->header.firstTick, tick / test::kSampleTicks * test::kSampleTicks);
        const BlockPlace* const keyframe = journal->keyframeBefore(tick);
        ASSERT_EQ(keyframe == nullptr, tick < kSecond);
        if (keyframe != nullptr) {
            EXPECT_EQ(keyframe->header.firstTick, tick / kSecond * kSecond);
        }
    }
    EXPECT_EQ(journal->blockAt(BlockType::Events, 3 * kSecond), nullptr);
    EXPECT_EQ(journal->blockAt(BlockType::Hash, 0), nullptr) << "a hash covers no tick";
}

TEST(JournalReader, ARecordingOfNothingHasNoTicks) {
    const Bytes bytes = test::journalBytes({}, true);
    const auto journal = JournalReader::parse(bytes, "sample");
    ASSERT_TRUE(journal);
    EXPECT_TRUE(journal->isComplete());
    EXPECT_FALSE(journal->ticks());
}

}  // namespace
}  // namespace tactooth
