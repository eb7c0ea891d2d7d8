// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/journal_repair.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "geometry/files/atomic_file.h"
#include "geometry/util/assert.h"
#include "journal/file/atomic_journal_file.h"
#include "journal/file/byte_source.h"
#include "journal/file/journal_appender.h"
#include "journal/file/journal_reader.h"
#include "journal/file/messages.h"
#include "journal/format/block_encoder.h"
#include "journal/format/container_blocks.h"

namespace tactooth {
namespace {

Expected<void> copyBeginning(const JournalReader& journal, std::uint64_t end, AtomicFile& out) {
    ForwardReader in(journal.source());
    for (std::uint64_t offset = 0; offset < end;) {
        const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(ForwardReader::kMost, end - offset));
        const Expected<std::span<const std::byte>> piece = in.view(offset, wanted);
        if (!piece) return Unexpected{piece.error()};
        if (piece->size() < wanted) return unexpected(msg::kJournalBlockUnreadable, journal.name(), offset);
        out.write(*piece);
        offset += wanted;
    }
    return {};
}

/// Writes the blocks behind another header, and the end that the recording has or, if it has none, a Recovered block.
Expected<void> writeAnew(const JournalReader& journal, const std::string& header, const JournalRepair& repair,
                         AtomicFile& out) {
    auto appender = JournalAppender::begin(std::make_unique<AtomicJournalFile>(out), journal.name(), header);
    if (!appender) return Unexpected{appender.error()};
    for (const BlockPlace& block : journal.blocks()) {
        const BlockType type = block.header.type;
        if (type == BlockType::Signature || type == BlockType::Index || type == BlockType::Closed) continue;
        const Expected<std::vector<std::byte>> stored = journal.storedPayload(block);
        if (!stored) return Unexpected{stored.error()};
        appender->appendStored(block.header, *stored);
    }
    const std::uint64_t tick = journal.ticks().value_or(TickRange()).end;
    if (journal.isComplete()) {
        appender->end(tick);
    } else if (!repair.hadEnd) {
        appender->append(recoveredBlock(tick, {repair.keptBytes, repair.droppedBytes}));
    }
    if (appender->fault()) return unexpected(*appender->fault());
    return {};
}

}  // namespace

Expected<JournalRepair> repairJournal(const std::filesystem::path& in, const std::filesystem::path& out,
                                      const std::optional<std::string>& header) {
    const Expected<JournalReader> journal = JournalReader::open(in);
    if (!journal) return Unexpected{journal.error()};
    JournalRepair repair;
    repair.blocks = journal->blocks().size();
    repair.keptBytes = journal->scan().end;
    repair.droppedBytes = journal->bytes() - repair.keptBytes;
    repair.hadEnd = journal->isComplete() || journal->isRecovered();

    Expected<AtomicFile> file = AtomicFile::create(out);
    if (!file) return Unexpected{file.error()};
    if (header) {
        if (auto written = writeAnew(*journal, *header, repair, *file); !written) return Unexpected{written.error()};
    } else if (auto copied = copyBeginning(*journal, repair.keptBytes, *file); !copied) {
        return Unexpected{copied.error()};
    }
    if (!header && !repair.hadEnd) {
        BlockEncoder encoder(journal->scan().lastCrc());
        const std::uint64_t tick = journal->ticks().value_or(TickRange()).end;
        const auto end = encoder.encode(recoveredBlock(tick, {repair.keptBytes, repair.droppedBytes}));
        TACTOOTH_ASSERT(end.has_value());
        file->write(*end);
    }
    if (auto done = file->commit(); !done) return Unexpected{done.error()};
    return repair;
}

}  // namespace tactooth
