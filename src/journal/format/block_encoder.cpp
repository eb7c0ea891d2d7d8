// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/format/block_encoder.h"

#include "geometry/util/assert.h"
#include "journal/codec/crc32c.h"

namespace tactooth {
namespace {

/// Smaller payloads are stored as they are: there is nothing to gain, and the end of a file keeps a known size.
constexpr std::size_t kLeastCompressed = 64;

}  // namespace

std::optional<std::vector<std::byte>> BlockEncoder::encode(const JournalBlock& block) {
    TACTOOTH_ASSERT(block.firstTick <= kMaxTick - block.ticks);
    if (block.payload.size() > kMaxRawBytes) return std::nullopt;
    std::optional<std::vector<std::byte>> frame;
    const bool mayShrink = block.payload.size() >= kLeastCompressed && block.type != BlockType::Signature;
    if (mayShrink) frame = compressor_.compress(block.payload);
    const std::vector<std::byte>& stored = frame ? *frame : block.payload;
    if (stored.size() > kMaxStoredBytes) return std::nullopt;
    BlockHeader header;
    header.type = block.type;
    header.flags = frame ? kCompressedFlag : std::uint16_t{0};
    header.firstTick = block.firstTick;
    header.ticks = block.ticks;
    header.storedBytes = static_cast<std::uint32_t>(stored.size());
    header.rawBytes = static_cast<std::uint32_t>(block.payload.size());
    return chain(header, stored);
}

std::vector<std::byte> BlockEncoder::chain(BlockHeader header, std::span<const std::byte> stored) {
    TACTOOTH_ASSERT(header.isValid());
    TACTOOTH_ASSERT(stored.size() == header.storedBytes);
    header.previousCrc = before_;
    header.crc = crc32c(stored, blockHeaderCrc(blockHeaderBytes(header)));
    before_ = header.crc;
    const BlockHeaderBytes head = blockHeaderBytes(header);
    std::vector<std::byte> bytes;
    bytes.reserve(head.size() + stored.size());
    bytes.insert(bytes.end(), head.begin(), head.end());
    bytes.insert(bytes.end(), stored.begin(), stored.end());
    return bytes;
}

}  // namespace tactooth
