// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: a recording is refused with a sentence, or it opens to blocks within the limits.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "geometry/util/byte_text.h"
#include "journal/codec/integer_columns.h"
#include "journal/file/attachment_reader.h"
#include "journal/file/journal_reader.h"
#include "journal/format/container_blocks.h"
#include "journal_samples.h"
#include "resealed_journal.h"
#include "support/mutation.h"
#include "support/sanitizer.h"

namespace tactooth {
namespace {

constexpr int kMutations = 200'000;

/// Largest resident memory of this program so far, bytes.
std::size_t peakMemory() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

void readPayload(const JournalReader& journal, const BlockPlace& block, std::span<const std::byte> payload) {
    ASSERT_EQ(payload.size(), block.header.rawBytes);
    ByteReader columns(payload);
    (void)getColumns(columns);
    (void)parseIndex(payload);
    (void)parseLost(payload);
    if (block.header.type == BlockType::Attachment) (void)readAttachment(journal, "fnv1a:0123456789abcdef", 1 << 20);
}

/// Returns whether it opens.
bool readAll(const std::string& bytes) {
    const auto journal = JournalReader::parse(asBytes(bytes), "mutated");
    if (!journal) {
        EXPECT_TRUE(journal.error().message().starts_with("mutated: ")) << journal.error().message();
        return false;
    }
    EXPECT_LE(journal->blocks().size(), bytes.size() / kBlockHeaderBytes);
    EXPECT_LE(journal->scan().end, bytes.size());
    for (const BlockPlace& block : journal->blocks()) {
        EXPECT_TRUE(block.header.isValid());
        EXPECT_LE(block.end(), journal->scan().end);
        const auto payload = journal->payload(block);
        if (payload) readPayload(*journal, block, *payload);
    }
    return true;
}

TEST(MutatedJournal, OpensOrIsRefusedInBoundedMemory) {
    std::vector<std::string> samples;
    for (const unsigned seed : {31U, 32U, 33U})
        samples.emplace_back(asText(test::journalBytes(test::sampleBlocks(seed, 1), seed != 32)));
    std::mt19937 random(34);
    const std::size_t before = peakMemory();
    const int rounds = test::cases(kMutations, kMutations / 20);
    int opened = 0;
    for (int round = 0; round < rounds && !HasFailure(); ++round) {
        std::string bytes = samples[test::below(random, samples.size())];
        for (std::size_t changes = 1 + test::below(random, 3); changes > 0; --changes)
            test::mutate(bytes, samples, random);
        if (round % 2 == 0) test::reseal(std::as_writable_bytes(std::span(bytes)));
        opened += readAll(bytes);
    }
    EXPECT_GT(opened, rounds / 10);
    EXPECT_LT(opened, rounds * 9 / 10);
    if (!test::isSanitized()) {
        EXPECT_LT(peakMemory() - before, std::size_t{2} * kMaxRawBytes);
    }
}

}  // namespace
}  // namespace tactooth
