// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "journal/codec/compression.h"
#include "journal/format/block_header.h"
#include "journal/format/journal_block.h"

namespace tactooth {

/// Turns blocks into the bytes of a file, in the order of the file: each is chained to the one before by its CRC-32C.
class BlockEncoder {
public:
    /// `before`: CRC-32C of the file's header, or of the block that the next one follows.
    explicit BlockEncoder(std::uint32_t before) : before_(before) {}

    /// Gives header and payload of a block, compressed where that makes it smaller. Gives nothing, and changes nothing,
    /// if the payload is larger than kMaxRawBytes, or than kMaxStoredBytes even when compressed.
    [[nodiscard]] std::optional<std::vector<std::byte>> encode(const JournalBlock& block);

    /// Chains a block of another file here; its payload stays as it is stored. `header` is valid.
    [[nodiscard]] std::vector<std::byte> chain(BlockHeader header, std::span<const std::byte> stored);

    /// CRC-32C of the last block.
    [[nodiscard]] std::uint32_t crc() const { return before_; }

private:
    std::uint32_t before_;
    Compressor compressor_;
};

}  // namespace tactooth
