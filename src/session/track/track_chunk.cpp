// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/track/track_chunk.h"

#include <utility>

#include "geometry/util/assert.h"
#include "journal/codec/compression.h"

namespace tactooth {

PackedBytes PackedBytes::of(std::vector<std::byte> raw) {
    PackedBytes packed;
    packed.rawSize = raw.size();
    if (raw.empty()) return packed;
    std::optional<std::vector<std::byte>> frame = Compressor().compress(raw);
    packed.bytes = frame ? std::move(*frame) : std::move(raw);
    return packed;
}

std::vector<std::byte> PackedBytes::unpacked() const {
    if (bytes.size() == rawSize) return bytes;
    std::optional<std::vector<std::byte>> raw = decompress(bytes, rawSize);
    TACTOOTH_ASSERT(raw.has_value());  // it was compressed in this process
    return std::move(*raw);
}

std::size_t TrackChunk::bytes() const {
    return ticks.capacity() * sizeof(TrackTick) + steps.capacity() * sizeof(ToothChange) +
           differences.bytes.capacity() + whole.bytes.capacity() + stride.bytes.capacity();
}

}  // namespace tactooth
