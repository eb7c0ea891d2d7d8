// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/live/session_feed.h"

#include <utility>

namespace tactooth {

SessionFeed::SessionFeed(CutModel& model)
    : tooth_(model.volume().tooth()),
      voxel_(model.volume().lattice().spacing()),
      surface_(model.surface()),
      loss_(model.loss()),
      history_(std::make_shared<const CutHistory>(model.history())) {}

void SessionFeed::fetchTicks(std::vector<Tick>& ticks) {
    ticks_.consume_all([&](const Tick& tick) { ticks.push_back(tick); });
}

std::shared_ptr<const Surface> SessionFeed::surface() const {
    const std::lock_guard lock(mutex_);
    return surface_;
}

TaggedMesh SessionFeed::exported() const { return exportedMesh(*surface(), voxel_); }

ToothLoss SessionFeed::loss() const {
    const std::lock_guard lock(mutex_);
    return loss_;
}

std::shared_ptr<const CutHistory> SessionFeed::history() const {
    const std::lock_guard lock(mutex_);
    return history_;
}

void SessionFeed::publish(CutModel& model) {
    CutHistory history = model.history();
    {
        const std::lock_guard lock(mutex_);
        surface_ = model.surface();
        loss_ = model.loss();
        if (history != *history_) history_ = std::make_shared<const CutHistory>(std::move(history));
    }
    surfaceUpdates_.fetch_add(1, std::memory_order_relaxed);
}

void SessionFeed::publish(const ToothLoss& loss) {
    const std::lock_guard lock(mutex_);
    loss_ = loss;
}

void SessionFeed::publish(const Tick& tick, double toForce) {
    deviceToForce_.add(toForce);
    ticks_.push(tick);
}

void SessionFeed::publishDevices(const Pose& mirror, ForceState force, bool atWorkspaceLimit) {
    mirror_.write(mirror);
    forceState_.store(force, std::memory_order_relaxed);
    atWorkspaceLimit_.store(atWorkspaceLimit, std::memory_order_relaxed);
}

}  // namespace tactooth
