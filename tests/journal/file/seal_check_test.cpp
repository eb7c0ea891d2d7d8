// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// What the signatures of a recording prove, and that no change goes unnoticed.
#include "journal/file/seal_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "fake_journal_file.h"
#include "geometry/files/atomic_file.h"
#include "journal/file/journal_repair.h"
#include "journal/file/journal_trim.h"
#include "journal/file/journal_writer.h"
#include "journal/format/block_encoder.h"
#include "journal/format/container_blocks.h"
#include "journal/format/signature_block.h"
#include "journal_samples.h"
#include "resealed_journal.h"
#include "sealed_samples.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using Bytes = std::span<const std::byte>;
using State = SealCheck::State;

class Seal : public testing::Test {
protected:
    /// Nothing if this is no recording any more.
    [[nodiscard]] std::optional<SealCheck> check(Bytes bytes) const {
        const auto journal = JournalReader::parse(bytes, "sample");
        if (!journal) return std::nullopt;
        const auto found = checkSeal(*journal, key_->publicKey());
        EXPECT_TRUE(found) << found.error().message();
        return *found;
    }
    [[nodiscard]] State stateOf(Bytes bytes) const { return check(bytes).value().state; }

    const std::shared_ptr<const SigningKey> key_ = test::sampleKey(1);
    const std::vector<JournalBlock> blocks_ = test::sampleBlocks(61, 2);
    const std::vector<std::byte> bytes_ = test::sealedBytes(blocks_, true, key_);
};

TEST_F(Seal, ACompleteRecordingIsIntact) {
    const SealCheck found = check(bytes_).value();
    EXPECT_EQ(found.state, State::Intact);
    EXPECT_EQ(found.signatures, blocks_.size() / 3 + 1);
    EXPECT_EQ(found.signedBytes, bytes_.size() - 60);  // all but the Closed block
    const auto journal = JournalReader::parse(bytes_, "sample");
    EXPECT_TRUE(hasSignature(*journal));
    std::vector<JournalBlock> read;
    for (const BlockPlace& place : journal->blocks()) {
        if (!isOfContainer(place.header.type)) {
            read.push_back({place.header.type, place.header.firstTick, place.header.ticks, *journal->payload(place)});
        }
    }
    ASSERT_EQ(read.size(), blocks_.size());
    for (std::size_t i = 0; i < read.size(); ++i) EXPECT_EQ(read[i].payload, blocks_[i].payload);
}

TEST_F(Seal, AnUnsealedRecordingHasNoSignature) {
    const std::vector<std::byte> plain = test::journalBytes(blocks_, true);
    EXPECT_FALSE(hasSignature(*JournalReader::parse(plain, "sample")));
    EXPECT_EQ(stateOf(plain), State::Changed) << "an end that nobody has signed";
}

TEST_F(Seal, EachChangedByteIsFoundAndItsPlaceNamed) {
    std::vector<std::byte> changed = bytes_;
    for (std::size_t i = 0; i < changed.size(); ++i) {
        changed[i] ^= std::byte{1} << i % 8;
        const auto found = check(changed);
        if (found) {
            ASSERT_NE(found->state, State::Intact) << "byte " << i;
            ASSERT_LE(found->signedBytes, i);
        }
        if (found && found->state == State::Changed) {
            ASSERT_LE(found->changedFrom, i);
            ASSERT_GT(found->changedBefore, i);
        }
        changed[i] = bytes_[i];
    }
    EXPECT_EQ(stateOf(changed), State::Intact);
}

/// Whoever knows the format can put all checksums right, but not the signatures.
TEST_F(Seal, EachByteThatAForgerChangesIsFound) {
    int signaturesFailed = 0;
    for (std::size_t i = 0; i < bytes_.size(); ++i) {
        std::vector<std::byte> forged = bytes_;
        forged[i] ^= std::byte{0x40};
        test::reseal(forged);
        if (forged == bytes_) continue;  // a checksum, which was put right
        const auto found = check(forged);
        if (!found) continue;
        ASSERT_NE(found->state, State::Intact) << "byte " << i;
        ASSERT_LE(found->signedBytes, i);
        signaturesFailed += found->state == State::Changed ? 1 : 0;
    }
    EXPECT_GT(signaturesFailed, static_cast<int>(bytes_.size()) / 2);
}

TEST_F(Seal, CutAnywhereItIsProvenUpToTheLastSignature) {
    const auto whole = JournalReader::parse(bytes_, "sample");
    for (std::size_t size = 0; size < bytes_.size(); ++size) {
        const auto found = check(Bytes(bytes_).first(size));
        if (!found) continue;  // the head is cut short
        ASSERT_EQ(found->state, State::CutOff) << size;
        std::uint64_t wanted = 0;
        for (const BlockPlace& place : whole->blocks()) {
            if (place.header.type == BlockType::Signature && place.end() <= size) wanted = place.end();
        }
        ASSERT_EQ(found->signedBytes, wanted) << size;
    }
}

TEST_F(Seal, AnotherKeyHasSignedNothing) {
    const auto journal = JournalReader::parse(bytes_, "sample");
    const auto found = checkSeal(*journal, test::sampleKey(2)->publicKey());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->state, State::Changed);
    EXPECT_EQ(found->signatures, 0U);
    EXPECT_EQ(found->signedBytes, 0U);
}

TEST_F(Seal, BytesBehindTheEndAreAChange) {
    std::vector<std::byte> longer = bytes_;
    longer.push_back({});
    EXPECT_EQ(stateOf(longer), State::Changed);
}

/// The blocks of a recording, as they are stored, without those that `drops`; chained anew behind the same header.
std::vector<std::byte> rechained(Bytes bytes, const std::function<bool(std::size_t, const BlockHeader&)>& drops) {
    const auto journal = JournalReader::parse(bytes, "sample");
    const std::size_t header = kHeaderFrameBytes + journal->headerJson().size();
    std::vector<std::byte> result(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(header));
    BlockEncoder encoder(journal->scan().headerCrc);
    for (std::size_t i = 0; i < journal->blocks().size(); ++i) {
        const BlockPlace& place = journal->blocks()[i];
        if (drops(i, place.header)) continue;
        const auto block = encoder.chain(place.header, *journal->storedPayload(place));
        result.insert(result.end(), block.begin(), block.end());
    }
    return result;
}

TEST_F(Seal, ABlockThatIsLeftOutIsMissed) {
    const std::size_t count = JournalReader::parse(bytes_, "sample").value().blocks().size();
    EXPECT_EQ(rechained(bytes_, [](std::size_t, const BlockHeader&) { return false; }), bytes_);
    for (std::size_t left = 0; left < count; ++left) {
        const auto forged = rechained(bytes_, [&](std::size_t i, const BlockHeader&) { return i == left; });
        EXPECT_NE(stateOf(forged), State::Intact) << left;
    }
}

TEST_F(Seal, AnEarlySignatureIsNoEnd) {
    // A good beginning, and an end that the forger adds.
    const auto journal = JournalReader::parse(bytes_, "sample");
    const auto& blocks = journal->blocks();
    const auto sign = std::ranges::find(blocks, BlockType::Signature, [](const auto& b) { return b.header.type; });
    ASSERT_NE(sign, blocks.end());
    std::vector<std::byte> forged(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(sign->end()));
    BlockEncoder encoder(sign->header.crc);
    const auto count = static_cast<std::uint64_t>(sign - blocks.begin()) + 1;
    for (const auto& block : {indexBlock(200, {}), closedBlock(200, {sign->end(), count + 1, 0})}) {
        const auto added = encoder.encode(block).value();
        forged.insert(forged.end(), added.begin(), added.end());
    }
    ASSERT_TRUE(JournalReader::parse(forged, "sample").value().isComplete());
    const SealCheck found = check(forged).value();
    EXPECT_EQ(found.state, State::Changed);
    EXPECT_EQ(found.signedBytes, sign->end());
}

TEST_F(Seal, SignaturesOfAnotherRecordingOfTheSameKeyDoNotFit) {
    const std::vector<std::byte> other = test::sealedBytes(test::sampleBlocks(62, 2), true, key_);
    const auto mine = JournalReader::parse(bytes_, "a"), theirs = JournalReader::parse(other, "b");
    std::vector<std::byte> forged(
        bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(kHeaderFrameBytes + mine->headerJson().size()));
    BlockEncoder encoder(mine->scan().headerCrc);
    ASSERT_EQ(mine->blocks().size(), theirs->blocks().size());
    for (std::size_t i = 0; i < mine->blocks().size(); ++i) {
        const bool takes = mine->blocks()[i].header.type == BlockType::Signature;
        const JournalReader& from = takes ? *theirs : *mine;
        const auto block = encoder.chain(from.blocks()[i].header, *from.storedPayload(from.blocks()[i]));
        forged.insert(forged.end(), block.begin(), block.end());
    }
    const SealCheck found = check(forged).value();
    EXPECT_EQ(found.state, State::Changed);
    EXPECT_EQ(found.signatures, 0U);
}

TEST_F(Seal, ALossIsPartOfTheProof) {
    const auto disk = std::make_shared<test::FakeDisk>();
    auto appender = JournalAppender::begin(test::fileOn(disk), "sample", test::sealedHeader(*key_), key_);
    ASSERT_TRUE(appender);
    ASSERT_TRUE(appender->append(blocks_[1]));
    ASSERT_TRUE(appender->appendLost({.blocks = 3, .bytes = 10, .firstTick = 0, .endTick = 5}));
    ASSERT_TRUE(appender->end(100));
    EXPECT_EQ(stateOf(disk->bytes()), State::Intact);
}

/// A writer that is not closed, as after a crash: all that was synced is signed.
TEST_F(Seal, TheWriterSignsAtEachSync) {
    const test::TemporaryFolder folder;
    JournalWriter::Options options;
    options.seal = key_;
    for (const bool closes : {false, true}) {
        const auto path = folder / (closes ? "closed" : "open");
        auto writer = JournalWriter::create(path, test::sealedHeader(*key_), options);
        ASSERT_TRUE(writer) << writer.error().message();
        for (const JournalBlock& block : blocks_) ASSERT_TRUE((*writer)->appendWhenRoom(block));
        ASSERT_TRUE((*writer)->flush());
        const std::uint64_t synced = (*writer)->bytes();
        if (closes) {
            ASSERT_TRUE((*writer)->close(400));
        }
        writer->reset();
        const auto journal = JournalReader::open(path);
        ASSERT_TRUE(journal) << journal.error().message();
        const auto found = checkSeal(*journal, key_->publicKey());
        ASSERT_TRUE(found);
        EXPECT_EQ(found->state, closes ? State::Intact : State::CutOff);
        EXPECT_GE(found->signedBytes, synced);
        if (!closes) {
            EXPECT_EQ(found->signedBytes, journal->bytes());
        }
    }
}

TEST_F(Seal, RepairedAndTrimmedCopiesAreNotSealed) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeFile(folder / "whole", Bytes(bytes_)));
    ASSERT_TRUE(writeFile(folder / "cut", Bytes(bytes_).first(bytes_.size() - 150)));
    const std::string header = R"({"title":"copy"})";
    ASSERT_TRUE(repairJournal(folder / "whole", folder / "repaired whole", header));
    ASSERT_TRUE(repairJournal(folder / "cut", folder / "repaired cut", header));
    ASSERT_TRUE(trimJournal(folder / "whole", folder / "trimmed", 0, 1000, header));
    for (const char* name : {"repaired whole", "repaired cut", "trimmed"}) {
        const auto journal = JournalReader::open(folder / name);
        ASSERT_TRUE(journal) << journal.error().message();
        EXPECT_FALSE(hasSignature(*journal)) << name;
        EXPECT_EQ(journal->headerJson(), header);
        EXPECT_FALSE(journal->cutOffAt());
        EXPECT_EQ(journal->isRecovered(), std::string(name) == "repaired cut");
        const std::ptrdiff_t kept = std::ranges::count_if(
            journal->blocks(), [](const BlockPlace& place) { return !isOfContainer(place.header.type); });
        EXPECT_EQ(kept, std::ssize(blocks_)) << name;
    }
}

TEST_F(Seal, MutatedRecordingsNeverPass) {
    std::mt19937 random(63);
    for (int i = 0; i < 2000; ++i) {
        std::vector<std::byte> damaged = bytes_;
        for (unsigned changes = 1 + random() % 4; changes > 0; --changes) {
            damaged[random() % damaged.size()] = static_cast<std::byte>(random());
        }
        if (i % 2 == 0) test::reseal(damaged);
        if (damaged == bytes_) continue;
        const auto found = check(damaged);
        EXPECT_TRUE(!found || found->state != State::Intact);
    }
}

}  // namespace
}  // namespace tactooth
