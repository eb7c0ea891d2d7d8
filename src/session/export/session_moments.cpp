// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/export/session_moments.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tactooth {
namespace {

constexpr double kPauseBetweenCuts = 0.4;  // s, as for the marks of undo

const char* nameOf(Edit edit) {
    static constexpr std::array kNames = {"reset", "undo", "redo"};  // as Edit
    return kNames[static_cast<std::size_t>(edit)];
}

}  // namespace

SessionMoments::SessionMoments(const SessionReplay& replay)
    : replay_(&replay), events_(replay.model().tooth().materials()), removedAtEdit_(removed()) {}

void SessionMoments::endCut() {
    if (!cut_) return;
    all_.push_back({cut_->lastContact, "cut ended", cut_->place, removed() - cut_->removedBefore});
    cut_.reset();
}

void SessionMoments::onEvent(double time, const SessionEvent& event) {
    if (std::holds_alternative<BeginEvent>(event)) {
        endCut();
        all_.push_back({time, "bur"});
    }
    if (const auto* const edit = std::get_if<EditEvent>(&event)) {
        const double change = removed() - removedAtEdit_;
        if (cut_) cut_->removedBefore += change;
        endCut();
        all_.push_back({time, nameOf(edit->edit), {}, change});
    }
    removedAtEdit_ = removed();
}

void SessionMoments::onTick(double time, const Tick& tick) {
    if (cut_ && time > cut_->lastContact + kPauseBetweenCuts) endCut();
    if (tick.input.cutting && tick.contact.triangles > 0 && tick.spindle.speedRpm > 0) {
        if (!cut_) {
            cut_ = Cut{time, removed(), tick.contact.proxy.position};
            all_.push_back({time, "cut begun", tick.contact.proxy.position});
        }
        cut_->lastContact = time;
        cut_->place = tick.contact.proxy.position;
    }
    events_.update(time, tick, replay_->model().loss());
}

void SessionMoments::finish() {
    endCut();
    for (const CutEvent& event : events_.all()) {
        all_.push_back({event.time, std::string(cutEventName(event.kind)), event.place});
    }
    std::ranges::stable_sort(all_, {}, &SessionMoment::time);
}

}  // namespace tactooth
