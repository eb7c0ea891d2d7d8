// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "session/track/session_track.h"

namespace tactooth {

/// Finds when the instrument touches the tooth first, while the track of the recording is being made.
class FirstTouch {
public:
    explicit FirstTouch(std::shared_ptr<const SessionTrack> track) : track_(std::move(track)) {}

    /// Searches the ticks that have come since the last call. Returns whether the answer is known: when the touch is
    /// there, or the track is finished without one.
    bool search();
    /// s since the session began; none: not known yet, or there is no touch.
    [[nodiscard]] std::optional<double> time() const { return time_; }

private:
    std::shared_ptr<const SessionTrack> track_;
    std::uint64_t searched_ = 0;  // ticks
    std::optional<double> time_;
};

}  // namespace tactooth
