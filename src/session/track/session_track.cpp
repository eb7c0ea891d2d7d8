// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/track/session_track.h"

#include <algorithm>
#include <utility>

#include "geometry/util/assert.h"
#include "session/recording/mirror_moments.h"

namespace tactooth {

SessionTrack::SessionTrack(const CutModel& start, double seconds)
    : tooth_(start.volume().tooth()),
      voxel_(start.volume().lattice().spacing()),
      startLoss_(start.loss()),
      surroundings_(start.surroundings()),
      expectedSeconds_(seconds) {
    for (const BrickKey& key : start.volume().cutBricks()) {
        startFields_.emplace(key, *start.volume().bricks().find(key));
    }
}

void SessionTrack::append(TrackChunk chunk) {
    const std::lock_guard lock(mutex_);
    TACTOOTH_ASSERT(!finished_);
    TACTOOTH_ASSERT(ticks_ == chunks_.size() * TrackChunk::kTicks);
    ticks_ += chunk.ticks.size();
    bytes_ += chunk.bytes();
    chunks_.push_back(std::make_shared<const TrackChunk>(std::move(chunk)));
}

void SessionTrack::add(const TrackEvent& event) {
    const std::lock_guard lock(mutex_);
    TACTOOTH_ASSERT(event.text != nullptr);
    events_.push_back(event);
}

void SessionTrack::add(TrackBur bur) {
    const std::lock_guard lock(mutex_);
    burs_.push_back(std::make_shared<const TrackBur>(std::move(bur)));
}

void SessionTrack::setMirror(std::vector<MirrorMoment> mirror) {
    const std::lock_guard lock(mutex_);
    mirror_ = std::move(mirror);
    bytes_ += mirror_.size() * sizeof(MirrorMoment);
}

std::vector<MirrorMoment> SessionTrack::mirror() const {
    const std::lock_guard lock(mutex_);
    return mirror_;
}

MirrorSight SessionTrack::mirrorAt(std::uint64_t moment) const {
    const std::lock_guard lock(mutex_);
    return sightAt(mirror_, moment);
}

void SessionTrack::finish(std::optional<double> differsAt, std::optional<Message> fault) {
    const std::lock_guard lock(mutex_);
    finished_ = true;
    differsAt_ = differsAt;
    fault_ = std::move(fault);
}

std::uint64_t SessionTrack::ticks() const {
    const std::lock_guard lock(mutex_);
    return ticks_;
}

double SessionTrack::seconds() const {
    const std::lock_guard lock(mutex_);
    return ticks_ == 0 ? 0 : chunks_.back()->ticks.back().time;
}

bool SessionTrack::isFinished() const {
    const std::lock_guard lock(mutex_);
    return finished_;
}

std::optional<double> SessionTrack::differsAt() const {
    const std::lock_guard lock(mutex_);
    return differsAt_;
}

std::optional<Message> SessionTrack::fault() const {
    const std::lock_guard lock(mutex_);
    return fault_;
}

std::vector<TrackEvent> SessionTrack::events() const {
    const std::lock_guard lock(mutex_);
    return events_;
}

/// A moment follows its tick, so a bur that came just after that tick is in the hand already.
std::shared_ptr<const TrackBur> SessionTrack::burAt(std::uint64_t moment) const {
    const std::lock_guard lock(mutex_);
    const auto later = std::ranges::upper_bound(burs_, moment, {}, &TrackBur::afterTicks);
    return later == burs_.begin() ? nullptr : *std::prev(later);
}

std::uint64_t SessionTrack::momentAt(double time) const {
    const std::lock_guard lock(mutex_);
    const auto startsLater = [](double at, const auto& chunk) { return at < chunk->ticks.front().time; };
    const auto later = std::upper_bound(chunks_.begin(), chunks_.end(), time, startsLater);
    if (later == chunks_.begin()) return 0;
    const std::vector<TrackTick>& ticks = (*std::prev(later))->ticks;
    const auto end = std::ranges::upper_bound(ticks, time, {}, &TrackTick::time);
    return static_cast<std::uint64_t>(later - chunks_.begin() - 1) * TrackChunk::kTicks +
           static_cast<std::uint64_t>(end - ticks.begin());
}

TrackTick SessionTrack::tickBefore(std::uint64_t moment) const {
    if (moment == 0) return {};
    return chunkAt((moment - 1) / TrackChunk::kTicks)->ticks[(moment - 1) % TrackChunk::kTicks];
}

std::shared_ptr<const TrackChunk> SessionTrack::chunkAt(std::uint64_t index) const {
    const std::lock_guard lock(mutex_);
    TACTOOTH_ASSERT(index < chunks_.size());
    return chunks_[index];
}

std::size_t SessionTrack::bytes() const {
    const std::lock_guard lock(mutex_);
    return bytes_;
}

std::shared_ptr<CutModel> SessionTrack::startModel() const {
    auto model = std::make_shared<CutModel>(tooth_, voxel_);
    model->surroundBy(surroundings_);
    if (!startFields_.empty()) model->adopt(startFields_, startLoss_.removed);
    return model;
}

}  // namespace tactooth
