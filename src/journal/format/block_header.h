// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "journal/format/journal_block.h"

namespace tactooth {

inline constexpr std::uint32_t kBlockMagic = 0x4B4C4254;       ///< "TBLK"
inline constexpr std::uint16_t kCompressedFlag = 1;            ///< the payload is one zstd frame
inline constexpr std::uint16_t kKnownFlags = kCompressedFlag;  ///< every other flag is zero in this version
inline constexpr std::size_t kBlockHeaderBytes = 36;

/// What stands before the payload of a block.
struct BlockHeader {
    BlockType type = BlockType::Events;
    std::uint16_t flags = 0;
    std::uint64_t firstTick = 0;
    std::uint32_t ticks = 0;
    std::uint32_t storedBytes = 0;  ///< of the payload in the file
    std::uint32_t rawBytes = 0;     ///< of the payload after decompression
    std::uint32_t previousCrc = 0;  ///< `crc` of the block before, or of the file's header
    std::uint32_t crc = 0;          ///< CRC-32C of the header before this field and of the stored payload

    [[nodiscard]] bool isCompressed() const { return (flags & kCompressedFlag) != 0; }
    [[nodiscard]] std::uint64_t endTick() const { return firstTick + ticks; }
    /// Whether it keeps the limits of journal_block.h and agrees with itself.
    [[nodiscard]] bool isValid() const;
};

using BlockHeaderBytes = std::array<std::byte, kBlockHeaderBytes>;

[[nodiscard]] BlockHeaderBytes blockHeaderBytes(const BlockHeader& header);
/// Nothing if this is no header of a block, or not a valid one.
[[nodiscard]] std::optional<BlockHeader> parseBlockHeader(std::span<const std::byte, kBlockHeaderBytes> bytes);

/// The CRC-32C of a header without its last field: `crc` is this, continued over the stored payload.
[[nodiscard]] std::uint32_t blockHeaderCrc(std::span<const std::byte, kBlockHeaderBytes> bytes);

}  // namespace tactooth
