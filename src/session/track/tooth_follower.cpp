// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/track/tooth_follower.h"

#include <utility>

namespace tactooth {

ToothFollower::ToothFollower(std::shared_ptr<const SessionTrack> track)
    : track_(std::move(track)),
      shown_(stateOf(TrackTooth(track_))),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void ToothFollower::follow(std::uint64_t moment) {
    const std::lock_guard lock(mutex_);
    goal_.reset();
    if (moment == shown_.moment && !busy_) return;
    goal_ = moment;
    wanted_.notify_one();
}

ToothFollower::Shown ToothFollower::shown() const {
    const std::lock_guard lock(mutex_);
    return shown_;
}

bool ToothFollower::isThere() const {
    const std::lock_guard lock(mutex_);
    return !goal_ && !busy_;
}

ToothFollower::Shown ToothFollower::stateOf(const TrackTooth& tooth) const {
    return {tooth.moment(), tooth.model().surface(), tooth.model().loss()};
}

void ToothFollower::run(const std::stop_token& stop) {
    TrackTooth tooth(track_);
    std::unique_lock lock(mutex_);
    while (wanted_.wait(lock, stop, [this] { return goal_.has_value(); })) {
        const std::uint64_t goal = *std::exchange(goal_, std::nullopt);
        busy_ = true;
        lock.unlock();
        tooth.moveTo(goal);
        Shown reached = stateOf(tooth);
        lock.lock();
        shown_ = std::move(reached);
        busy_ = false;
    }
}

}  // namespace tactooth
