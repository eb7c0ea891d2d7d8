// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/util/expected.h"
#include "journal/file/byte_source.h"
#include "journal/format/block_header.h"

namespace tactooth {

/// A block in a file.
struct BlockPlace {
    std::uint64_t offset = 0;
    BlockHeader header;

    [[nodiscard]] std::uint64_t end() const { return offset + kBlockHeaderBytes + header.storedBytes; }
};

/// What a walk through a whole recording finds.
struct JournalScan {
    std::string headerJson;
    std::uint32_t headerCrc = 0;
    std::vector<BlockPlace> blocks;  ///< up to the last one whose chain holds, or to the Closed block
    std::uint64_t end = 0;           ///< byte behind them

    /// CRC-32C that a block behind them is chained to.
    [[nodiscard]] std::uint32_t lastCrc() const { return blocks.empty() ? headerCrc : blocks.back().header.crc; }
};

/// Walks through a recording and checks each byte. Takes no more memory than a piece of the file, and the places of at
/// most kMaxBlocks blocks. Fails with one sentence if this is no recording, has another version, a damaged head or too
/// many blocks, or if reading stops. `name`: for messages.
[[nodiscard]] Expected<JournalScan> scanJournal(const ByteSource& source, const std::string& name);

}  // namespace tactooth
