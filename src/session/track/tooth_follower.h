// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "session/track/track_tooth.h"

namespace tactooth {

/// The surface of a recorded tooth for a picture. A thread of its own goes to the moment that was asked for last, so
/// that the picture never waits.
class ToothFollower {
public:
    explicit ToothFollower(std::shared_ptr<const SessionTrack> track);

    /// The moment that is wanted; the track has it.
    void follow(std::uint64_t moment);

    struct Shown {
        std::uint64_t moment = 0;
        std::shared_ptr<const Surface> surface;  ///< of the tooth, without the bodies around it; not null
        ToothLoss loss;
    };
    /// The newest result.
    [[nodiscard]] Shown shown() const;
    /// Whether the moment that is wanted is shown.
    [[nodiscard]] bool isThere() const;

private:
    void run(const std::stop_token& stop);
    [[nodiscard]] Shown stateOf(const TrackTooth& tooth) const;

    std::shared_ptr<const SessionTrack> track_;
    mutable std::mutex mutex_;
    std::condition_variable_any wanted_;
    std::optional<std::uint64_t> goal_;
    Shown shown_;
    bool busy_ = false;
    std::jthread thread_;  // last: it uses the members above
};

}  // namespace tactooth
