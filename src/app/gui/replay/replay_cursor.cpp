// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/replay_cursor.h"

#include <algorithm>
#include <utility>

namespace tactooth {
namespace {

/// s: who jumps to the event before while the replay plays does not want the one that has just passed.
constexpr double kJustPassed = 0.4;

constexpr double kSameTime = 1e-6;  // s: less than a tick

}  // namespace

double lengthOf(const SessionTrack& track) {
    return track.isFinished() ? track.seconds() : std::max(track.expectedSeconds(), track.seconds());
}

void ReplayCursor::setOther(std::shared_ptr<const SessionTrack> other, double shift) {
    other_ = std::move(other);
    shift_ = shift;
    jumpTo(time_);  // the time line may be shorter now
}

double ReplayCursor::length() const {
    return other_ ? std::max(lengthOf(*track_), lengthOf(*other_) + shift_) : lengthOf(*track_);
}

/// A recording that is finished before the time line ends waits for nothing more.
double ReplayCursor::ready() const {
    double ready = length();
    if (!track_->isFinished()) ready = std::min(ready, track_->seconds());
    if (other_ && !other_->isFinished()) ready = std::min(ready, other_->seconds() + shift_);
    return std::max(0.0, ready);
}

void ReplayCursor::advance(double dt) {
    if (!playing_) return;
    const double end = ready();
    if (time_ < end) time_ = std::min(time_ + speed_ * dt, end);
    if (time_ >= end && isFinished()) playing_ = false;
}

/// At the end it begins again.
void ReplayCursor::setPlaying(bool playing) {
    if (playing && isFinished() && time_ >= length()) time_ = 0;
    playing_ = playing;
}

void ReplayCursor::jumpTo(double time) { time_ = std::clamp(time, 0.0, length()); }

void ReplayCursor::step(int ticks) {
    playing_ = false;
    const double end = track_->seconds();
    const bool isBehind = other_ && (time_ > end || (time_ >= end && ticks > 0));
    const SessionTrack& stepped = isBehind ? *other_ : *track_;
    const double shift = isBehind ? shift_ : 0;
    const auto now = static_cast<std::int64_t>(stepped.momentAt(time_ - shift));
    const auto last = static_cast<std::int64_t>(stepped.ticks());
    const std::int64_t goal = std::clamp<std::int64_t>(now + ticks, 0, last);
    if (isBehind && goal == now) return;  // the other has ended, too
    jumpTo(goal == 0 ? 0 : stepped.tickBefore(static_cast<std::uint64_t>(goal)).time + shift);
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
