// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/lockfree/spsc_queue.hpp>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "geometry/util/triple_buffer.h"
#include "haptics/force_pipeline.h"
#include "haptics/haptic_simulation.h"
#include "haptics/latency_histogram.h"
#include "haptics/servo_loop.h"
#include "session/simulation/cut_model.h"

namespace tactooth {

/// What a running session shows: window, commands and tests read it, and nothing they do can hold up the servo thread.
/// A surface shares with the one before it each part that did not change, so the parts that are new are the change.
class SessionFeed {
public:
    explicit SessionFeed(CutModel& model);
    SessionFeed(const SessionFeed&) = delete;
    SessionFeed& operator=(const SessionFeed&) = delete;

    // For observers, on any thread where nothing else is said.

    /// One thread (the window's): appends the ticks since the last call to `ticks`, oldest first. Ticks older than two
    /// seconds are lost.
    void fetchTicks(std::vector<Tick>& ticks);
    [[nodiscard]] std::shared_ptr<const Surface> surface() const;
    /// Number of surfaces so far.
    [[nodiscard]] std::uint64_t surfaceUpdates() const { return surfaceUpdates_.load(std::memory_order_relaxed); }
    /// The surface for files: see exportedMesh.
    [[nodiscard]] TaggedMesh exported() const;
    [[nodiscard]] ToothLoss loss() const;
    [[nodiscard]] MaterialVolumes removed() const { return loss().removed; }
    /// Of the tooth: what the indices of `removed` mean.
    [[nodiscard]] const MaterialRegistry& materials() const { return tooth_->materials(); }
    /// The steps that can be undone and redone. Never null.
    [[nodiscard]] std::shared_ptr<const CutHistory> history() const;

    /// One thread (the window's): the motion of the mirror since the start, in the tooth frame.
    [[nodiscard]] const Pose& mirrorMotion() { return mirror_.refresh(), mirror_.value(); }
    /// The state of the force output.
    [[nodiscard]] ForceState forceState() const { return forceState_.load(std::memory_order_relaxed); }
    /// See DeviceSet::isAtWorkspaceLimit.
    [[nodiscard]] bool isDeviceAtWorkspaceLimit() const { return atWorkspaceLimit_.load(std::memory_order_relaxed); }

    [[nodiscard]] const ServoTiming& timing() const { return loop_->timing(); }
    /// Time from reading the device to sending the force, us.
    [[nodiscard]] const LatencyHistogram& deviceToForce() const { return deviceToForce_; }
    [[nodiscard]] bool isRealTime() const { return loop_->isRealTime(); }
    [[nodiscard]] bool limitsCpuLatency() const { return loop_->limitsCpuLatency(); }

    // For the threads of the session.

    /// Before any observer: the servo loop, which outlives the feed's last reader.
    void setLoop(const ServoLoop& loop) { loop_ = &loop; }
    /// Carving thread: the surface has changed.
    void publish(CutModel& model);
    /// Carving thread: a cut so small that it moves no part of the surface still removes volume.
    void publish(const ToothLoss& loss);
    /// Servo thread, wait-free: the tick is complete. `toForce`: from reading the device to sending the force, us.
    void publish(const Tick& tick, double toForce);
    /// Servo thread, wait-free.
    void publishDevices(const Pose& mirror, ForceState force, bool atWorkspaceLimit);

private:
    static constexpr std::size_t kTickCapacity = 2048;

    std::shared_ptr<const LayeredTooth> tooth_;
    double voxel_;
    const ServoLoop* loop_ = nullptr;

    mutable std::mutex mutex_;  // of the next three
    std::shared_ptr<const Surface> surface_;
    ToothLoss loss_;
    std::shared_ptr<const CutHistory> history_;

    boost::lockfree::spsc_queue<Tick, boost::lockfree::capacity<kTickCapacity>> ticks_;
    TripleBuffer<Pose> mirror_;
    LatencyHistogram deviceToForce_;
    std::atomic<ForceState> forceState_{ForceState::Off};
    std::atomic<bool> atWorkspaceLimit_{false};
    std::atomic<std::uint64_t> surfaceUpdates_{0};
};

}  // namespace tactooth
