// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/journal_scan.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/util/assert.h"
#include "geometry/util/byte_text.h"
#include "journal/codec/crc32c.h"
#include "journal/file/messages.h"
#include "journal/format/file_header.h"

namespace tactooth {
namespace {

using Bytes = std::span<const std::byte>;

Expected<std::vector<std::byte>> bytesAt(const ByteSource& source, std::uint64_t offset, std::size_t count) {
    std::vector<std::byte> bytes(count);
    const Expected<std::size_t> read = source.readAt(offset, bytes);
    if (!read) return Unexpected{read.error()};
    bytes.resize(*read);
    return bytes;
}

/// Reads the head of the file into `scan`.
Expected<void> readHeader(const ByteSource& source, const std::string& name, JournalScan& scan) {
    const auto start = bytesAt(source, 0, kHeaderStartBytes);
    if (!start) return Unexpected{start.error()};
    const HeaderStart found = parseHeaderStart(*start);
    if (found.kind == HeaderStart::Kind::NoJournal) return unexpected(msg::kNoJournal, name);
    if (found.kind == HeaderStart::Kind::OtherVersion)
        return unexpected(msg::kJournalOtherVersion, name, found.version, kJournalVersion);
    const std::size_t size = kHeaderFrameBytes + found.jsonBytes;
    if (found.kind == HeaderStart::Kind::Damaged || source.size() < size)
        return unexpected(msg::kJournalHeadDamaged, name);
    const auto header = bytesAt(source, 0, size);
    if (!header) return Unexpected{header.error()};
    if (header->size() < size || crc32c(Bytes(*header).first(size - sizeof(std::uint32_t))) != fileHeaderCrc(*header))
        return unexpected(msg::kJournalHeadDamaged, name);
    scan.headerJson = asText(Bytes(*header).subspan(kHeaderStartBytes, found.jsonBytes));
    scan.headerCrc = fileHeaderCrc(*header);
    scan.end = size;
    return {};
}

/// Continues a CRC-32C over bytes of the file; nothing if the file ends before them.
Expected<std::optional<std::uint32_t>> crcOver(ForwardReader& in, std::uint64_t offset, std::uint64_t count,
                                               std::uint32_t crc) {
    using Result = std::optional<std::uint32_t>;
    for (const std::uint64_t end = offset + count; offset < end;) {
        const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(ForwardReader::kMost, end - offset));
        const Expected<Bytes> piece = in.view(offset, wanted);
        if (!piece) return Unexpected{piece.error()};
        if (piece->size() < wanted) return Result();
        crc = crc32c(*piece, crc);
        offset += wanted;
    }
    return Result(crc);
}

/// The header of the block at `offset`; nothing if there is no whole block that is chained to `before`.
Expected<std::optional<BlockHeader>> wholeBlockAt(ForwardReader& in, std::uint64_t offset, std::uint32_t before) {
    using Result = std::optional<BlockHeader>;
    const Expected<Bytes> bytes = in.view(offset, kBlockHeaderBytes);
    if (!bytes) return Unexpected{bytes.error()};
    if (bytes->size() < kBlockHeaderBytes) return Result();
    const auto head = bytes->first<kBlockHeaderBytes>();
    const std::optional<BlockHeader> header = parseBlockHeader(head);
    if (!header || header->previousCrc != before) return Result();
    const auto crc = crcOver(in, offset + kBlockHeaderBytes, header->storedBytes, blockHeaderCrc(head));
    if (!crc) return Unexpected{crc.error()};
    return crc->has_value() && **crc == header->crc ? Result(header) : Result();
}

}  // namespace

Expected<JournalScan> scanJournal(const ByteSource& source, const std::string& name) {
    JournalScan scan;
    if (auto head = readHeader(source, name, scan); !head) return Unexpected{head.error()};
    ForwardReader in(source);
    while (scan.blocks.empty() || scan.blocks.back().header.type != BlockType::Closed) {
        const Expected<std::optional<BlockHeader>> header = wholeBlockAt(in, scan.end, scan.lastCrc());
        if (!header) return Unexpected{header.error()};
        if (!header->has_value()) break;
        if (scan.blocks.size() == kMaxBlocks) return unexpected(msg::kJournalTooManyBlocks, name, kMaxBlocks);
        scan.blocks.push_back({scan.end, **header});
        scan.end = scan.blocks.back().end();
    }
    TACTOOTH_ASSERT(scan.end >= kHeaderFrameBytes);
    return scan;
}

}  // namespace tactooth
