// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>

#include "journal/codec/crc32c.h"
#include "journal/format/block_header.h"
#include "journal/format/file_header.h"

namespace tactooth::test {

inline void putWord(std::span<std::byte> bytes, std::size_t at, std::uint32_t word) {
    std::memcpy(bytes.subspan(at, sizeof word).data(), &word, sizeof word);
}

/// Puts the CRC of a damaged header right; gives its end, 0 if the file ends in it.
inline std::size_t resealHeader(std::span<std::byte> bytes) {
    if (bytes.size() < kHeaderFrameBytes) return 0;
    const std::size_t end = kHeaderFrameBytes + parseHeaderStart(bytes.first(kHeaderStartBytes)).jsonBytes;
    if (bytes.size() < end) return 0;
    putWord(bytes, end - sizeof(std::uint32_t), crc32c(bytes.first(end - sizeof(std::uint32_t))));
    return end;
}

/// Puts the CRCs of a damaged recording right, as far as its blocks can still be found: what lies behind them must not
/// rely on them.
inline void reseal(std::span<std::byte> bytes) {
    std::size_t at = resealHeader(bytes);
    if (at == 0) return;
    std::uint32_t before = fileHeaderCrc(bytes.first(at));
    while (bytes.size() - at >= kBlockHeaderBytes) {
        const auto head = bytes.subspan(at).first<kBlockHeaderBytes>();
        const std::optional<BlockHeader> header = parseBlockHeader(head);
        if (!header || bytes.size() - at - kBlockHeaderBytes < header->storedBytes) return;
        putWord(head, kBlockHeaderBytes - 2 * sizeof before, before);
        before = crc32c(bytes.subspan(at + kBlockHeaderBytes, header->storedBytes), blockHeaderCrc(head));
        putWord(head, kBlockHeaderBytes - sizeof before, before);
        at += kBlockHeaderBytes + header->storedBytes;
    }
}

}  // namespace tactooth::test
