// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/replay_cursor.h"

#include <algorithm>

namespace tactooth {
namespace {

/// s: who jumps to the event before while the replay plays does not want the one that has just passed.
constexpr double kJustPassed = 0.4;

constexpr double kSameTime = 1e-6;  // s: less than a tick

}  // namespace

double ReplayCursor::length() const {
    return track_->isFinished() ? track_->seconds() : std::max(track_->expectedSeconds(), track_->seconds());
}

void ReplayCursor::advance(double dt) {
    if (!playing_) return;
    const double ready = track_->seconds();
    if (time_ < ready) time_ = std::min(time_ + speed_ * dt, ready);
    if (time_ >= ready && track_->isFinished()) playing_ = false;
}

/// At the end it begins again.
void ReplayCursor::setPlaying(bool playing) {
    if (playing && track_->isFinished() && time_ >= track_->seconds()) time_ = 0;
    playing_ = playing;
}

void ReplayCursor::jumpTo(double time) { time_ = std::clamp(time, 0.0, length()); }

void ReplayCursor::step(int ticks) {
    playing_ = false;
    const auto now = static_cast<std::int64_t>(moment());
    const auto last = static_cast<std::int64_t>(track_->ticks());
    const std::int64_t goal = std::clamp<std::int64_t>(now + ticks, 0, last);
    time_ = goal == 0 ? 0 : track_->tickBefore(static_cast<std::uint64_t>(goal)).time;
}

void ReplayCursor::jumpToNext(const std::vector<double>& times) {
    const auto next = std::ranges::upper_bound(times, time_ + kSameTime);
    if (next != times.end()) jumpTo(*next);
}

void ReplayCursor::jumpToPrevious(const std::vector<double>& times) {
    const double before = time_ - (playing_ ? kJustPassed * std::max(1.0, speed_) : kSameTime);
    const auto later = std::ranges::lower_bound(times, before);
    if (later != times.begin()) jumpTo(*std::prev(later));
}

}  // namespace tactooth
