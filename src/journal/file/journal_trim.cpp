// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/journal_trim.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "geometry/files/file_bytes.h"
#include "geometry/util/assert.h"
#include "journal/file/atomic_journal_file.h"
#include "journal/file/journal_appender.h"
#include "journal/file/messages.h"
#include "journal/format/container_blocks.h"

namespace tactooth {
namespace {

/// What belongs to the whole recording, whenever it was written.
bool isTimeless(BlockType type) { return type == BlockType::Attachment || !isKnown(type); }

/// Whether the ticks of a block meet those from `range.begin` to before `range.end`, or its moment is in them or at
/// their end.
bool meets(const BlockHeader& header, const TickRange& range) {
    if (header.ticks == 0) return range.begin <= header.firstTick && header.firstTick <= range.end;
    return header.firstTick < range.end && range.begin < header.endTick();
}

bool isKept(const BlockHeader& header, const TickRange& range) {
    if (isTimeless(header.type)) return true;
    const bool isWrittenAnew = header.type == BlockType::Index || header.type == BlockType::Closed ||
                               header.type == BlockType::Trimmed || header.type == BlockType::Signature;
    return !isWrittenAnew && meets(header, range);
}

/// The ticks of the blocks that are kept; none if they cover no tick of the range that was asked for.
std::optional<TickRange> coveredTicks(const JournalReader& journal, const TickRange& asked, const TickRange& kept) {
    if (asked.begin == asked.end) return std::nullopt;
    std::optional<TickRange> covered;
    bool isEmpty = true;
    for (const BlockPlace& block : journal.blocks()) {
        const BlockHeader& header = block.header;
        if (header.ticks == 0 || !isKept(header, kept) || isTimeless(header.type)) continue;
        isEmpty = isEmpty && !meets(header, asked);
        if (!covered) covered = TickRange{header.firstTick, header.endTick()};
        covered->begin = std::min(covered->begin, header.firstTick);
        covered->end = std::max(covered->end, header.endTick());
    }
    return isEmpty ? std::nullopt : covered;
}

}  // namespace

Expected<JournalTrim> trimJournal(const std::filesystem::path& in, const std::filesystem::path& out,
                                  std::uint64_t fromTick, std::uint64_t toTick,
                                  const std::optional<std::string>& header) {
    TACTOOTH_ASSERT(fromTick <= toTick && toTick <= kMaxTick);
    const Expected<JournalReader> journal = JournalReader::open(in);
    if (!journal) return Unexpected{journal.error()};
    const BlockPlace* const keyframe = journal->keyframeBefore(fromTick);
    const TickRange kept{keyframe != nullptr ? keyframe->header.firstTick : 0, toTick};
    const auto covered = coveredTicks(*journal, {fromTick, toTick}, kept);
    if (!covered) return unexpected(msg::kJournalTrimEmpty, journal->name(), fromTick, toTick);

    Expected<AtomicFile> file = AtomicFile::create(out);
    if (!file) return Unexpected{file.error()};
    auto appender = JournalAppender::begin(std::make_unique<AtomicJournalFile>(*file), displayName(out),
                                           header.value_or(journal->headerJson()));
    if (!appender) return Unexpected{appender.error()};
    JournalTrim trim{*covered, 0};
    appender->append(trimmedBlock({fromTick, toTick}));
    for (const BlockPlace& block : journal->blocks()) {
        if (!isKept(block.header, kept)) continue;
        const Expected<std::vector<std::byte>> stored = journal->storedPayload(block);
        if (!stored) return Unexpected{stored.error()};
        appender->appendStored(block.header, *stored);
        ++trim.blocks;
    }
    if (!appender->end(covered->end)) return unexpected(*appender->fault());
    if (auto done = file->commit(); !done) return Unexpected{done.error()};
    return trim;
}

}  // namespace tactooth
