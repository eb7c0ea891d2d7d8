// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

// The pieces of a recording (docs/session-file.md).

namespace tactooth {

/// What a block holds. The numbers are those of the file: never change one, never use one again. A reader passes over
/// numbers that it does not know.
enum class BlockType : std::uint16_t {
    Events = 1,      ///< inputs of the session, tick by tick
    Hash = 2,        ///< hash of the session's state
    Keyframe = 3,    ///< whole state of the session: replay can begin here
    Attachment = 4,  ///< a piece of a file that the session needs (attachment.h)
    Index = 5,       ///< where the keyframes are; written at a clean end
    Recovered = 6,   ///< the end of a file that was cut off and repaired
    Closed = 7,      ///< the clean end: nothing follows
    Note = 8,        ///< what else the session has to say
    Lost = 9,        ///< blocks are missing here: the queue was full
    Trimmed = 10,    ///< the file is a part of a longer recording
    Signature = 11,  ///< all before it is signed: the recording is sealed (signature_block.h)
    Mirror = 12,     ///< how the mouth mirror was held, and from where it was looked at
};

/// Whether this version knows the type.
[[nodiscard]] constexpr bool isKnown(BlockType type) { return type >= BlockType::Events && type <= BlockType::Mirror; }

/// Whether the container itself writes and reads blocks of this type.
[[nodiscard]] constexpr bool isOfContainer(BlockType type) {
    return type == BlockType::Index || type == BlockType::Recovered || type == BlockType::Closed ||
           type == BlockType::Lost || type == BlockType::Trimmed || type == BlockType::Signature;
}

/// A block before it is written. `payload` is not compressed.
struct JournalBlock {
    BlockType type = BlockType::Events;
    std::uint64_t firstTick = 0;
    std::uint32_t ticks = 0;  ///< 0: a block of one moment, before `firstTick`
    std::vector<std::byte> payload;
};

/// Version of the format. A reader refuses every other one: the same bytes would mean something else.
inline constexpr std::uint32_t kJournalVersion = 1;

// Limits of a file, so that damaged and hostile files cost bounded memory. A second of a session takes about 5 kB.
inline constexpr std::uint32_t kMaxHeaderBytes = 1U << 20;  ///< of the JSON text
inline constexpr std::uint32_t kMaxStoredBytes = 1U << 24;  ///< of a payload in the file
inline constexpr std::uint32_t kMaxRawBytes = 1U << 26;     ///< of a payload after decompression
inline constexpr std::size_t kMaxBlocks = 1U << 20;         ///< two days at six blocks a second
/// Ticks end before this one, so that the end of a block never overflows; 4 kHz take 70 million years to get there.
inline constexpr std::uint64_t kMaxTick = std::uint64_t{1} << 63;

}  // namespace tactooth
