// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/kernel/event_merger.h"

#include <gtest/gtest.h>

#include <random>

namespace tactooth {
namespace {

/// The order of a session, as three threads might have run it.
std::vector<SessionEvent> randomOrder(std::mt19937& random, int count) {
    std::vector<SessionEvent> events;
    TickNumber tick = 0, carved = 0;
    SurfaceNumber published = 0, received = 0;
    std::uint32_t pending = 0, retired = 0;
    for (int i = 0; i < count; ++i) {
        switch (random() % 4) {
            case 0:
            case 1: {
                const std::uint32_t taken = pending > 0 ? static_cast<std::uint32_t>(random() % (pending + 1)) : 0;
                pending -= taken, retired += taken, ++tick;
                events.emplace_back(TickEvent{{}, taken});
                break;
            }
            case 2: {
                carved += static_cast<TickNumber>(random() % (tick - carved + 1));
                const bool changes = random() % 2 == 0;
                published += changes ? 1 : 0;
                events.emplace_back(CarveEvent{carved, changes});
                break;
            }
            default: {
                const bool receives = published > received && random() % 2 == 0;
                if (receives) received = published;
                const auto recycled = static_cast<std::uint32_t>(random() % (retired + 1));
                retired -= recycled;
                const bool sent = random() % 2 == 0;
                pending += sent ? 1 : 0;
                events.emplace_back(ListEvent{tick, receives ? received : 0, recycled, sent});
            }
        }
    }
    return events;
}

/// Whether each event finds what it depends on.
bool isInOrder(const std::vector<SessionEvent>& events) {
    TickNumber ticks = 0;
    SurfaceNumber published = 0;
    std::int64_t pending = 0, retired = 0;
    for (const SessionEvent& event : events) {
        if (const auto* tick = std::get_if<TickEvent>(&event)) {
            ++ticks, pending -= tick->taken, retired += tick->taken;
        } else if (const auto* carve = std::get_if<CarveEvent>(&event)) {
            if (carve->tick > ticks) return false;
            published += carve->published ? 1 : 0;
        } else if (const auto* list = std::get_if<ListEvent>(&event)) {
            if (list->tick > ticks || list->surface > published) return false;
            retired -= list->recycled, pending += list->sent ? 1 : 0;
        }
        if (pending < 0 || retired < 0) return false;
    }
    return true;
}

TEST(EventMerger, FindsAnOrderHoweverTheQueuesAreRead) {
    std::mt19937 random(21);
    int shuffled = 0;
    for (int run = 0; run < 300; ++run) {
        const std::vector<SessionEvent> order = randomOrder(random, 200);
        ASSERT_TRUE(isInOrder(order));
        std::deque<EventLanes::ServoRecord> servo;
        std::deque<EventLanes::CarveRecord> carving;
        std::deque<ListEvent> listing;
        for (const SessionEvent& event : order) {
            if (const auto* tick = std::get_if<TickEvent>(&event)) servo.emplace_back(*tick);
            if (const auto* carve = std::get_if<CarveEvent>(&event)) carving.emplace_back(*carve);
            if (const auto* list = std::get_if<ListEvent>(&event)) listing.push_back(*list);
        }
        EventMerger merger;
        std::vector<SessionEvent> merged;
        while (!servo.empty() || !carving.empty() || !listing.empty()) {
            const auto which = random() % 3;
            if (which == 0 && !servo.empty()) merger.servo(servo.front()), servo.pop_front();
            if (which == 1 && !carving.empty()) merger.carving(carving.front()), carving.pop_front();
            if (which == 2 && !listing.empty()) merger.listing(listing.front()), listing.pop_front();
            if (random() % 8 == 0) merger.take(merged);
            shuffled += merger.waiting() > 0 ? 1 : 0;
        }
        merger.take(merged);
        EXPECT_EQ(merger.waiting(), 0U);
        EXPECT_EQ(merged.size(), order.size());
        EXPECT_TRUE(isInOrder(merged));
    }
    EXPECT_GT(shuffled, 1000) << "some had to wait";
}

TEST(EventMerger, KeepsWhatMissesItsPredecessors) {
    EventMerger merger;
    std::vector<SessionEvent> events;
    merger.carving(CarveEvent{1, true});
    merger.listing(ListEvent{1, 1, 0, true});
    merger.take(events);
    EXPECT_TRUE(events.empty());
    EXPECT_EQ(merger.waiting(), 2U);
    merger.servo(TickEvent{});
    merger.servo(TickEvent{{}, 1});
    merger.take(events);
    ASSERT_EQ(events.size(), 4U);
    EXPECT_TRUE(std::holds_alternative<TickEvent>(events[0]));
    EXPECT_TRUE(std::holds_alternative<CarveEvent>(events[1]));
    EXPECT_TRUE(std::holds_alternative<ListEvent>(events[2]));
}

TEST(EventLanes, SaysWhenAQueueWasFull) {
    EventLanes lanes;
    for (int i = 0; i < 100'000; ++i) lanes.listing({});
    EXPECT_TRUE(lanes.hasOverflowed());
    EventMerger merger;
    lanes.drain(merger);
    EXPECT_GT(merger.waiting(), 1000U);
    EXPECT_LT(merger.waiting(), 100'000U);
}

}  // namespace
}  // namespace tactooth
