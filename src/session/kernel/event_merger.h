// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "session/kernel/event_lanes.h"
#include "session/kernel/session_event.h"

namespace tactooth {

/// Brings the events of three threads into one order in which each event comes after all that it depends on: a carving
/// turn after the tick that it saw, a neighbour list after the surface that it is for, a tick after the lists that it
/// has taken. Between events that do not depend on each other any order gives the same session. One thread.
class EventMerger {
public:
    // For EventLanes::drain.
    void servo(const EventLanes::ServoRecord& record) { servo_.push_back(record); }
    void carving(const EventLanes::CarveRecord& record) { carving_.push_back(record); }
    void listing(const ListEvent& record) { listing_.push_back(record); }

    /// Appends the events whose predecessors are all there. The others wait for a later call.
    void take(std::vector<SessionEvent>& events);
    /// The number of events that wait.
    [[nodiscard]] std::size_t waiting() const { return servo_.size() + carving_.size() + listing_.size(); }

private:
    [[nodiscard]] bool takeServo(std::vector<SessionEvent>& events);
    [[nodiscard]] bool takeCarving(std::vector<SessionEvent>& events);
    [[nodiscard]] bool takeListing(std::vector<SessionEvent>& events);

    std::deque<EventLanes::ServoRecord> servo_;
    std::deque<EventLanes::CarveRecord> carving_;
    std::deque<ListEvent> listing_;
    // Of the events in order so far.
    TickNumber ticks_ = 0;
    SurfaceNumber published_ = 0;
    std::uint64_t sent_ = 0;
    std::uint64_t taken_ = 0;
    std::uint64_t recycled_ = 0;
};

}  // namespace tactooth
