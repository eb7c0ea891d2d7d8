// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/journal_reader.h"

#include <algorithm>
#include <utility>

#include "geometry/files/file_bytes.h"
#include "geometry/files/readable_file.h"
#include "geometry/util/assert.h"
#include "journal/codec/compression.h"
#include "journal/codec/crc32c.h"
#include "journal/file/messages.h"

namespace tactooth {

Expected<JournalReader> JournalReader::open(const std::filesystem::path& path) {
    Expected<ReadableFile> file = ReadableFile::open(path);
    if (!file) return Unexpected{file.error()};
    return read(sourceOf(std::move(*file)), displayName(path));
}

Expected<JournalReader> JournalReader::parse(std::span<const std::byte> bytes, std::string name) {
    return read(sourceOf(bytes), std::move(name));
}

Expected<JournalReader> JournalReader::read(std::unique_ptr<ByteSource> source, std::string name) {
    Expected<JournalScan> scan = scanJournal(*source, name);
    if (!scan) return Unexpected{scan.error()};
    return JournalReader(std::move(source), std::move(name), std::move(*scan));
}

JournalReader::JournalReader(std::unique_ptr<ByteSource> source, std::string name, JournalScan scan)
    : source_(std::move(source)), name_(std::move(name)), scan_(std::move(scan)) {
    TACTOOTH_ASSERT(scan_.end <= source_->size());
}

bool JournalReader::isComplete() const {
    return !scan_.blocks.empty() && scan_.blocks.back().header.type == BlockType::Closed;
}

bool JournalReader::isRecovered() const {
    return !scan_.blocks.empty() && scan_.blocks.back().header.type == BlockType::Recovered;
}

std::optional<std::uint64_t> JournalReader::cutOffAt() const {
    if (scan_.end == source_->size()) return std::nullopt;
    return scan_.end;
}

std::optional<TickRange> JournalReader::ticks() const {
    std::optional<TickRange> range;
    for (const BlockPlace& block : scan_.blocks) {
        const BlockHeader& header = block.header;
        if (header.ticks == 0) continue;
        if (!range) range = TickRange{header.firstTick, header.endTick()};
        range->begin = std::min(range->begin, header.firstTick);
        range->end = std::max(range->end, header.endTick());
    }
    return range;
}

Expected<std::vector<std::byte>> JournalReader::storedPayload(const BlockPlace& block) const {
    TACTOOTH_ASSERT(block.header.isValid());
    TACTOOTH_ASSERT(block.end() <= scan_.end);
    std::vector<std::byte> stored(block.header.storedBytes);
    const Expected<std::size_t> read = source_->readAt(block.offset + kBlockHeaderBytes, stored);
    if (!read) return Unexpected{read.error()};
    const bool isWhole =
        *read == stored.size() && crc32c(stored, blockHeaderCrc(blockHeaderBytes(block.header))) == block.header.crc;
    if (!isWhole) return unexpected(msg::kJournalBlockUnreadable, name_, block.offset);
    return stored;
}

Expected<std::vector<std::byte>> JournalReader::payload(const BlockPlace& block) const {
    Expected<std::vector<std::byte>> stored = storedPayload(block);
    if (!stored || !block.header.isCompressed()) return stored;
    std::optional<std::vector<std::byte>> raw = decompress(*stored, block.header.rawBytes);
    if (!raw) return unexpected(msg::kJournalBlockUnreadable, name_, block.offset);
    return std::move(*raw);
}

const BlockPlace* JournalReader::blockAt(BlockType type, std::uint64_t tick) const {
    const auto covers = [&](const BlockPlace& block) {
        const BlockHeader& header = block.header;
        return header.type == type && header.firstTick <= tick && tick < header.endTick();
    };
    const auto found = std::ranges::find_if(scan_.blocks, covers);
    return found != scan_.blocks.end() ? &*found : nullptr;
}

const BlockPlace* JournalReader::keyframeBefore(std::uint64_t tick) const {
    const BlockPlace* best = nullptr;
    for (const BlockPlace& block : scan_.blocks) {
        if (block.header.type != BlockType::Keyframe || block.header.firstTick > tick) continue;
        if (best == nullptr || block.header.firstTick >= best->header.firstTick) best = &block;
    }
    return best;
}

}  // namespace tactooth
