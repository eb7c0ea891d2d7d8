// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>

#include "session/track/session_track.h"

namespace tactooth {

/// The place in a recorded session that is shown, and how it moves on. Another recording may lie on the same time line.
class ReplayCursor {
public:
    static constexpr std::array kSpeeds = {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0};
    static constexpr double kOwnSpeed = 1;  ///< that of the session

    /// At the start, playing at the speed of the session.
    explicit ReplayCursor(std::shared_ptr<const SessionTrack> track) : track_(std::move(track)) {}

    /// Puts another recording on the time line: it begins `shift` s after the first, or before it if that is negative.
    void setOther(std::shared_ptr<const SessionTrack> other, double shift);
    void removeOther() { setOther(nullptr, 0); }

    /// `dt` s of the clock later. At the end of all recordings it pauses; where a track is not made yet it waits.
    void advance(double dt);
    void setPlaying(bool playing);
    [[nodiscard]] bool isPlaying() const { return playing_; }
    /// One of kSpeeds.
    void setSpeed(double speed) { speed_ = speed; }
    [[nodiscard]] double speed() const { return speed_; }
    /// Goes to a time, s; a time outside of the time line counts as its nearest end. A time that a track does not have
    /// yet is shown as soon as it has.
    void jumpTo(double time);
    /// Goes on by `ticks`, or back if it is negative, and pauses. Behind the end of the first recording they are ticks
    /// of the other.
    void step(int ticks);
    /// Goes to the nearest of these times, in ascending order, after the cursor or before it. It stays if there is
    /// none.
    void jumpToNext(const std::vector<double>& times);
    void jumpToPrevious(const std::vector<double>& times);

    /// s since the first session began
    [[nodiscard]] double time() const { return time_; }
    /// The moment to show: the last one that the track has up to `time`.
    [[nodiscard]] std::uint64_t moment() const { return track_->momentAt(time_); }
    /// s since the other session began; negative before that.
    [[nodiscard]] double otherTime() const { return time_ - shift_; }
    /// The moment of the other recording, which is there.
    [[nodiscard]] std::uint64_t otherMoment() const { return other_->momentAt(otherTime()); }
    /// Of the time line, s.
    [[nodiscard]] double length() const;
    /// Up to this time all recordings can be shown, s.
    [[nodiscard]] double ready() const;

private:
    [[nodiscard]] bool isFinished() const { return track_->isFinished() && (!other_ || other_->isFinished()); }

    std::shared_ptr<const SessionTrack> track_, other_;  // other_ may be null
    double shift_ = 0;                                   // s
    double time_ = 0;
    double speed_ = kOwnSpeed;
    bool playing_ = true;
};

/// Length of a recording as far as it is known, s.
[[nodiscard]] double lengthOf(const SessionTrack& track);

}  // namespace tactooth
