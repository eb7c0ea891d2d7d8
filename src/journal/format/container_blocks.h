// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "journal/format/journal_block.h"

// The blocks that the container writes itself. Each pair of functions is one payload, there and back; the way back
// gives nothing for a payload of another form.

namespace tactooth {

/// Where a keyframe is.
struct KeyframePlace {
    std::uint64_t tick = 0;
    std::uint64_t offset = 0;  ///< of its block in the file
    [[nodiscard]] bool operator==(const KeyframePlace&) const = default;
};
/// `tick`: the end of the recording.
[[nodiscard]] JournalBlock indexBlock(std::uint64_t tick, std::span<const KeyframePlace> keyframes);
[[nodiscard]] std::optional<std::vector<KeyframePlace>> parseIndex(std::span<const std::byte> payload);

/// The clean end. Its payload is never compressed, so it is the last 60 bytes of a complete file.
struct ClosedFacts {
    std::uint64_t indexOffset = 0;  ///< of the Index block
    std::uint64_t blocks = 0;       ///< before the Closed block
    std::uint64_t lostBlocks = 0;   ///< that the queue had no room for
    [[nodiscard]] bool operator==(const ClosedFacts&) const = default;
};
[[nodiscard]] JournalBlock closedBlock(std::uint64_t tick, const ClosedFacts& facts);
[[nodiscard]] std::optional<ClosedFacts> parseClosed(std::span<const std::byte> payload);

/// The end that a repair gave a file.
struct RecoveredFacts {
    std::uint64_t cutOffAt = 0;      ///< byte where the whole blocks ended
    std::uint64_t droppedBytes = 0;  ///< that followed
    [[nodiscard]] bool operator==(const RecoveredFacts&) const = default;
};
[[nodiscard]] JournalBlock recoveredBlock(std::uint64_t tick, const RecoveredFacts& facts);
[[nodiscard]] std::optional<RecoveredFacts> parseRecovered(std::span<const std::byte> payload);

/// Blocks that were not written, and the ticks that they held.
struct LostFacts {
    std::uint64_t blocks = 0;
    std::uint64_t bytes = 0;  ///< of their payloads
    std::uint64_t firstTick = 0;
    std::uint64_t endTick = 0;
    [[nodiscard]] bool operator==(const LostFacts&) const = default;

    /// Counts a block. It is valid.
    void add(const JournalBlock& block);
};
[[nodiscard]] JournalBlock lostBlock(const LostFacts& facts);
[[nodiscard]] std::optional<LostFacts> parseLost(std::span<const std::byte> payload);

/// Which part of a longer recording a file is.
struct TrimmedFacts {
    std::uint64_t fromTick = 0, toTick = 0;  ///< what was asked for; the file may begin earlier, at a keyframe
    [[nodiscard]] bool operator==(const TrimmedFacts&) const = default;
};
[[nodiscard]] JournalBlock trimmedBlock(const TrimmedFacts& facts);
[[nodiscard]] std::optional<TrimmedFacts> parseTrimmed(std::span<const std::byte> payload);

}  // namespace tactooth
