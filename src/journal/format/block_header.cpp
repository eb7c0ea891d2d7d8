// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/format/block_header.h"

#include <algorithm>

#include "geometry/util/assert.h"
#include "geometry/util/byte_stream.h"
#include "journal/codec/crc32c.h"

namespace tactooth {

bool BlockHeader::isValid() const {
    const bool fits = storedBytes <= kMaxStoredBytes && rawBytes <= kMaxRawBytes;
    const bool isEndKnown = firstTick <= kMaxTick - ticks;
    const bool sizesAgree = isCompressed() ? storedBytes < rawBytes : storedBytes == rawBytes;
    return fits && isEndKnown && sizesAgree && (flags & ~kKnownFlags) == 0;
}

BlockHeaderBytes blockHeaderBytes(const BlockHeader& header) {
    TACTOOTH_ASSERT(header.isValid());
    ByteWriter out;
    out.put(kBlockMagic);
    out.put(header.type);
    out.put(header.flags);
    out.put(header.firstTick);
    out.put(header.ticks);
    out.put(header.storedBytes);
    out.put(header.rawBytes);
    out.put(header.previousCrc);
    out.put(header.crc);
    TACTOOTH_ASSERT(out.bytes().size() == kBlockHeaderBytes);
    BlockHeaderBytes bytes;
    std::ranges::copy(out.bytes(), bytes.begin());
    return bytes;
}

std::optional<BlockHeader> parseBlockHeader(std::span<const std::byte, kBlockHeaderBytes> bytes) {
    ByteReader in(bytes);
    if (in.get<std::uint32_t>() != kBlockMagic) return std::nullopt;
    BlockHeader header;
    header.type = in.get<BlockType>();
    header.flags = in.get<std::uint16_t>();
    header.firstTick = in.get<std::uint64_t>();
    header.ticks = in.get<std::uint32_t>();
    header.storedBytes = in.get<std::uint32_t>();
    header.rawBytes = in.get<std::uint32_t>();
    header.previousCrc = in.get<std::uint32_t>();
    header.crc = in.get<std::uint32_t>();
    TACTOOTH_ASSERT(in.ok() && in.left() == 0);
    if (!header.isValid()) return std::nullopt;
    return header;
}

std::uint32_t blockHeaderCrc(std::span<const std::byte, kBlockHeaderBytes> bytes) {
    return crc32c(bytes.first<kBlockHeaderBytes - sizeof(std::uint32_t)>());
}

}  // namespace tactooth
