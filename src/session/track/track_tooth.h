// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>

#include "session/track/session_track.h"

namespace tactooth {

/// The tooth of a recorded session at any moment: it goes forward and back without simulating. At each moment it has
/// the bits that the replay has after the same number of ticks. One thread.
class TrackTooth {
public:
    /// At moment 0.
    explicit TrackTooth(std::shared_ptr<const SessionTrack> track);

    /// Goes to a moment that the track has.
    void moveTo(std::uint64_t moment);
    [[nodiscard]] std::uint64_t moment() const { return moment_; }
    [[nodiscard]] const CutModel& model() const { return *model_; }

private:
    /// A chunk, and how many of its steps have been taken.
    struct Place {
        std::uint64_t chunk = 0;
        std::size_t steps = 0;
    };
    using Fields = std::map<BrickKey, CutField>;

    [[nodiscard]] Place placeOf(std::uint64_t moment) const;
    void applyWhole(std::uint64_t first, std::uint64_t last);
    void applySteps(std::uint64_t chunk, std::size_t from, std::size_t to);
    void apply(std::span<const std::byte> difference);
    CutField& fieldOf(const BrickKey& key);

    std::shared_ptr<const SessionTrack> track_;
    std::shared_ptr<CutModel> model_;
    std::uint64_t moment_ = 0;
    Place place_;
    ToothLoss loss_;
    Fields changed_;  // during a move
    std::uint64_t unpackedChunk_ = 0;
    std::vector<std::byte> unpacked_;  // the differences of that chunk; playing stays in one for a while
};

}  // namespace tactooth
