// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>

#include "session/track/session_track.h"

namespace tactooth {

/// The place in a recorded session that is shown, and how it moves on.
class ReplayCursor {
public:
    static constexpr std::array kSpeeds = {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0};
    static constexpr double kOwnSpeed = 1;  ///< that of the session

    /// At the start, playing at the speed of the session.
    explicit ReplayCursor(std::shared_ptr<const SessionTrack> track) : track_(std::move(track)) {}

    /// `dt` s of the clock later. At the end of the recording it pauses; where the track is not made yet it waits.
    void advance(double dt);
    void setPlaying(bool playing);
    [[nodiscard]] bool isPlaying() const { return playing_; }
    /// One of kSpeeds.
    void setSpeed(double speed) { speed_ = speed; }
    [[nodiscard]] double speed() const { return speed_; }
    /// Goes to a time, s; a time outside of the recording counts as its nearest end. A time that the track does not
    /// have yet is shown as soon as it has.
    void jumpTo(double time);
    /// Goes on by `ticks`, or back if it is negative, and pauses.
    void step(int ticks);
    /// Goes to the nearest of these times, in ascending order, after the cursor or before it. It stays if there is
    /// none.
    void jumpToNext(const std::vector<double>& times);
    void jumpToPrevious(const std::vector<double>& times);

    /// s since the session began
    [[nodiscard]] double time() const { return time_; }
    /// The moment to show: the last one that the track has up to `time`.
    [[nodiscard]] std::uint64_t moment() const { return track_->momentAt(time_); }
    /// s
    [[nodiscard]] double length() const;

private:
    std::shared_ptr<const SessionTrack> track_;
    double time_ = 0;
    double speed_ = kOwnSpeed;
    bool playing_ = true;
};

}  // namespace tactooth
