// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/lockfree/spsc_queue.hpp>

#include <atomic>
#include <variant>

#include "session/kernel/session_event.h"

namespace tactooth {

/// What one thread reports to the recorder: each has a queue of its own, so that none waits. A queue that is full loses
/// its newest event; then the record ends there.
class EventLanes {
public:
    using ServoRecord = std::variant<TickEvent, ForceEvent, TickHashEvent>;
    using CarveRecord = std::variant<CarveEvent, EditEvent, CarvingHashEvent>;

    // Each of one thread; wait-free, no allocation.
    void servo(const ServoRecord& record) { push(servo_, record); }
    void carving(const CarveRecord& record) { push(carving_, record); }
    void listing(const ListEvent& record) { push(listing_, record); }

    /// One thread: takes what has come, in the order of each queue.
    template <class Sink>
    void drain(Sink& sink) {
        // An event depends on earlier ones of the other queues, so what is read last holds more: the sink waits with
        // it.
        servo_.consume_all([&](const ServoRecord& record) { sink.servo(record); });
        carving_.consume_all([&](const CarveRecord& record) { sink.carving(record); });
        listing_.consume_all([&](const ListEvent& record) { sink.listing(record); });
    }

    /// Whether a queue was full. Any thread.
    [[nodiscard]] bool hasOverflowed() const { return overflowed_.load(std::memory_order_relaxed); }

private:
    template <class Queue, class Record>
    void push(Queue& queue, const Record& record) {
        if (overflowed_.load(std::memory_order_relaxed) || queue.push(record)) return;
        overflowed_.store(true, std::memory_order_relaxed);
    }

    static constexpr std::size_t kCapacity = 1 << 14;  // four seconds at 4 kHz
    template <class Record>
    using Queue = boost::lockfree::spsc_queue<Record, boost::lockfree::capacity<kCapacity>>;

    Queue<ServoRecord> servo_;
    Queue<CarveRecord> carving_;
    Queue<ListEvent> listing_;
    std::atomic<bool> overflowed_{false};
};

}  // namespace tactooth
