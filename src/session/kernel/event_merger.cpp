// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/kernel/event_merger.h"

#include <variant>

namespace tactooth {

bool EventMerger::takeServo(std::vector<SessionEvent>& events) {
    if (servo_.empty()) return false;
    if (const auto* tick = std::get_if<TickEvent>(&servo_.front())) {
        if (taken_ + tick->taken > sent_) return false;
        taken_ += tick->taken;
        ++ticks_;
        events.emplace_back(*tick);
    } else if (const auto* force = std::get_if<ForceEvent>(&servo_.front())) {
        events.emplace_back(*force);
    } else {
        events.emplace_back(std::get<TickHashEvent>(servo_.front()));
    }
    servo_.pop_front();
    return true;
}

bool EventMerger::takeCarving(std::vector<SessionEvent>& events) {
    if (carving_.empty()) return false;
    if (const auto* carve = std::get_if<CarveEvent>(&carving_.front())) {
        if (carve->tick > ticks_) return false;
        published_ += carve->published ? 1 : 0;
        events.emplace_back(*carve);
    } else if (const auto* edit = std::get_if<EditEvent>(&carving_.front())) {
        published_ += edit->published ? 1 : 0;
        events.emplace_back(*edit);
    } else {
        events.emplace_back(std::get<CarvingHashEvent>(carving_.front()));
    }
    carving_.pop_front();
    return true;
}

bool EventMerger::takeListing(std::vector<SessionEvent>& events) {
    if (listing_.empty()) return false;
    const ListEvent& list = listing_.front();
    if (list.tick > ticks_ || list.surface > published_ || recycled_ + list.recycled > taken_) return false;
    recycled_ += list.recycled;
    sent_ += list.sent ? 1 : 0;
    events.emplace_back(list);
    listing_.pop_front();
    return true;
}

void EventMerger::take(std::vector<SessionEvent>& events) {
    while (takeCarving(events) || takeListing(events) || takeServo(events)) continue;
}

}  // namespace tactooth
