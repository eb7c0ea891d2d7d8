// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/track/chunk_builder.h"

#include <utility>

#include "geometry/util/assert.h"

namespace tactooth {

ChunkBuilder::ChunkBuilder(const CutModel& start)
    : untouched_(CutField::untouched(start.volume().lattice().spacing())),
      lastLoss_(start.loss()),
      first_{{}, start.loss()},
      strideFirst_{{}, start.loss()} {
    for (const BrickKey& key : start.volume().cutBricks()) {
        last_.emplace(key, *start.volume().bricks().find(key));
    }
    chunk_.ticks.reserve(TrackChunk::kTicks);
}

void ChunkBuilder::addStep(const CutModel& model, const std::vector<BrickKey>& touched) {
    const std::size_t before = differences_.size();
    for (const BrickKey& key : touched) {
        const Brick* const brick = model.volume().bricks().find(key);  // null after a reset
        const CutField& now = brick != nullptr ? static_cast<const CutField&>(*brick) : untouched_;
        CutField& last = last_.try_emplace(key, untouched_).first->second;
        first_.fields.try_emplace(key, last);
        differences_.add(key, last, now);
        last = now;
    }
    differences_.add(lastLoss_, model.loss());
    lastLoss_ = model.loss();
    if (differences_.size() == before) return;
    chunk_.steps.push_back({static_cast<std::uint32_t>(chunk_.ticks.size()), differences_.size()});
}

/// To the last moment, from which `before` begins anew.
PackedBytes ChunkBuilder::differenceSince(Before& before) {
    CutDelta difference;
    for (const auto& [key, field] : before.fields) difference.add(key, field, last_.at(key));
    difference.add(before.loss, lastLoss_);
    before = {{}, lastLoss_};
    return PackedBytes::of(difference.take());
}

TrackChunk ChunkBuilder::take() {
    for (const auto& [key, field] : first_.fields) strideFirst_.fields.try_emplace(key, field);
    if (++taken_ % TrackChunk::kStride == 0) chunk_.stride = differenceSince(strideFirst_);
    chunk_.whole = differenceSince(first_);
    chunk_.differences = PackedBytes::of(differences_.take());
    chunk_.steps.shrink_to_fit();
    TrackChunk done = std::exchange(chunk_, {});
    chunk_.ticks.reserve(TrackChunk::kTicks);
    return done;
}

}  // namespace tactooth
