// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <unordered_map>

#include "session/track/cut_delta.h"
#include "session/track/track_chunk.h"

namespace tactooth {

/// Collects ticks and changes of the tooth as the chunks of a track.
class ChunkBuilder {
public:
    /// `start`: the tooth before the first event.
    explicit ChunkBuilder(const CutModel& start);

    [[nodiscard]] bool isFull() const { return chunk_.ticks.size() == TrackChunk::kTicks; }
    [[nodiscard]] bool hasTicks() const { return !chunk_.ticks.empty(); }
    void add(const TrackTick& tick) { chunk_.ticks.push_back(tick); }
    /// The tooth has changed. `touched`: the bricks whose fields may be others than at the last call.
    void addStep(const CutModel& model, const std::vector<BrickKey>& touched);
    /// Gives the chunk and begins the next one.
    [[nodiscard]] TrackChunk take();

private:
    /// The bricks that were touched since a moment as they were then, and the lost volumes.
    struct Before {
        std::map<BrickKey, CutField> fields;
        ToothLoss loss;
    };
    [[nodiscard]] PackedBytes differenceSince(Before& before);

    CutField untouched_;
    std::unordered_map<BrickKey, CutField, BrickKeyHash> last_;  // of the bricks that were touched so far
    ToothLoss lastLoss_;
    Before first_;             // before this chunk
    Before strideFirst_;       // before the chunks of this stride
    std::uint64_t taken_ = 0;  // chunks
    CutDelta differences_;
    TrackChunk chunk_;
};

}  // namespace tactooth
