// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/track/track_tooth.h"

#include <algorithm>
#include <utility>

#include "geometry/util/assert.h"
#include "session/track/cut_delta.h"

namespace tactooth {

TrackTooth::TrackTooth(std::shared_ptr<const SessionTrack> track)
    : track_(std::move(track)), model_(track_->startModel()), loss_(model_->loss()) {}

/// Moment n has all steps of its chunk that come before tick n + 1.
TrackTooth::Place TrackTooth::placeOf(std::uint64_t moment) const {
    if (moment == 0) return {};
    const std::uint64_t chunk = (moment - 1) / TrackChunk::kTicks;
    const auto ticks = static_cast<std::uint32_t>((moment - 1) % TrackChunk::kTicks + 1);
    const std::shared_ptr<const TrackChunk> there = track_->chunkAt(chunk);
    const auto later = std::ranges::upper_bound(there->steps, ticks, {}, &ToothChange::afterTicks);
    return {chunk, static_cast<std::size_t>(later - there->steps.begin())};
}

void TrackTooth::moveTo(std::uint64_t moment) {
    TACTOOTH_ASSERT(moment <= track_->ticks());
    const Place goal = placeOf(moment);
    // Differences may be applied in any order, and in either direction.
    if (goal.chunk == place_.chunk) {
        applySteps(goal.chunk, std::min(goal.steps, place_.steps), std::max(goal.steps, place_.steps));
    } else {
        const Place& first = goal.chunk < place_.chunk ? goal : place_;
        const Place& last = goal.chunk < place_.chunk ? place_ : goal;
        applyWhole(first.chunk, last.chunk);
        applySteps(first.chunk, 0, first.steps);  // taken back from the whole
        applySteps(last.chunk, 0, last.steps);
    }
    place_ = goal;
    moment_ = moment;
    const Fields fields = std::exchange(changed_, {});
    if (!fields.empty()) model_->replace(fields, loss_);
}

/// All chunks from `first` to before `last`.
void TrackTooth::applyWhole(std::uint64_t first, std::uint64_t last) {
    constexpr std::uint64_t kStride = TrackChunk::kStride;
    for (std::uint64_t chunk = first; chunk < last;) {
        const bool isStride = chunk % kStride == 0 && chunk + kStride <= last;
        const std::uint64_t next = chunk + (isStride ? kStride : 1);
        const std::shared_ptr<const TrackChunk> end = track_->chunkAt(next - 1);
        apply((isStride ? end->stride : end->whole).unpacked());
        chunk = next;
    }
}

void TrackTooth::applySteps(std::uint64_t chunk, std::size_t from, std::size_t to) {
    if (from == to) return;
    const std::shared_ptr<const TrackChunk> there = track_->chunkAt(chunk);
    if (unpacked_.empty() || unpackedChunk_ != chunk) {
        unpacked_ = there->differences.unpacked();
        unpackedChunk_ = chunk;
    }
    const std::size_t begin = from == 0 ? 0 : there->steps[from - 1].end;
    apply(std::span(unpacked_).subspan(begin, there->steps[to - 1].end - begin));
}

void TrackTooth::apply(std::span<const std::byte> difference) {
    applyDelta(
        difference, [this](const BrickKey& key) -> CutField& { return fieldOf(key); }, loss_);
}

CutField& TrackTooth::fieldOf(const BrickKey& key) {
    const auto known = changed_.find(key);
    if (known != changed_.end()) return known->second;
    const Brick* const brick = model_->volume().bricks().find(key);
    return changed_
        .emplace(key, brick != nullptr ? static_cast<const CutField&>(*brick)
                                       : CutField::untouched(model_->volume().lattice().spacing()))
        .first->second;
}

}  // namespace tactooth
