// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the reader of recordings refuses them with a sentence, or gives blocks within the limits. Also
// with the checksums put right, which no chance would: what lies behind them must not rely on them.
#include "fuzz/fuzz_target.h"
#include "journal/codec/integer_columns.h"
#include "journal/file/attachment_reader.h"
#include "journal/file/journal_reader.h"
#include "journal/format/attachment.h"
#include "journal/format/container_blocks.h"
#include "journal/resealed_journal.h"

namespace tactooth::test {
namespace {

constexpr std::size_t kMaxAttachment = 1 << 20;

void requireValidColumns(std::span<const std::byte> payload) {
    ByteReader in(payload);
    const std::vector<IntegerColumn> columns = getColumns(in);
    require(in.ok() || columns.empty(), "damaged columns give none");
    for (const IntegerColumn& column : columns)
        require(column.values.size() == columns.front().values.size(), "columns have one length");
}

void requireValidPayload(const JournalReader& journal, const BlockPlace& block, std::span<const std::byte> payload) {
    require(payload.size() == block.header.rawBytes, "a payload has the size that its header states");
    requireValidColumns(payload);
    (void)parseIndex(payload);
    (void)parseClosed(payload);
    (void)parseLost(payload);
    if (block.header.type != BlockType::Attachment) return;
    const auto piece = parseAttachment(payload);
    if (!piece) return;
    const auto content = readAttachment(journal, piece->name, kMaxAttachment);
    if (!content) return requireSentence(content.error(), 1000);
    require(content->size() <= kMaxAttachment, "attachments keep the limit");
}

/// Whether it is a whole recording; one that is cut off is read as well.
bool isWhole(std::span<const std::byte> bytes) {
    const auto journal = JournalReader::parse(bytes, "fuzz");
    if (!journal) return requireSentence(journal.error()), false;
    require(journal->blocks().size() <= bytes.size() / kBlockHeaderBytes, "blocks have bytes");
    bool isReadable = true;
    for (const BlockPlace& block : journal->blocks()) {
        require(block.header.isValid() && block.end() <= journal->scan().end, "blocks are within the file");
        const auto payload = journal->payload(block);
        isReadable = isReadable && payload.has_value();
        if (!payload) {
            requireSentence(payload.error());
        } else {
            requireValidPayload(*journal, block, *payload);
        }
    }
    return isReadable && !journal->cutOffAt();
}

bool accepts(std::span<const std::byte> bytes) {
    const bool isWholeAsItIs = isWhole(bytes);
    std::vector<std::byte> sealed(bytes.begin(), bytes.end());
    reseal(sealed);
    return isWhole(sealed) || isWholeAsItIs;
}

const AddFuzzTarget added({"journal", accepts});

}  // namespace
}  // namespace tactooth::test
