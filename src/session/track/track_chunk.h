// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "session/track/track_tick.h"

namespace tactooth {

/// Bytes that were compressed, if that makes them fewer.
struct PackedBytes {
    std::vector<std::byte> bytes;
    std::size_t rawSize = 0;

    [[nodiscard]] static PackedBytes of(std::vector<std::byte> raw);
    [[nodiscard]] std::vector<std::byte> unpacked() const;
};

/// A change of the tooth's surface.
struct ToothChange {
    std::uint32_t afterTicks = 0;  ///< number of the chunk's ticks before it
    std::size_t end = 0;           ///< of its difference among those of the chunk, bytes
};

/// A part of a track: some ticks, and how the tooth changed meanwhile.
struct TrackChunk {
    static constexpr std::uint64_t kTicks = 1000;  ///< of each chunk but the last
    static constexpr std::uint64_t kStride = 16;   ///< chunks that a far jump takes at once

    std::vector<TrackTick> ticks;
    std::vector<ToothChange> steps;  ///< in their order
    PackedBytes differences;         ///< of all steps, one behind the other (CutDelta)
    PackedBytes whole;               ///< from the first to the last moment of the chunk (CutDelta)
    /// The same of kStride chunks, in the last one of them. A bur that works for long in one place changes the same
    /// words again and again, so this is less than all of their differences.
    PackedBytes stride;

    [[nodiscard]] std::size_t bytes() const;
};

}  // namespace tactooth
