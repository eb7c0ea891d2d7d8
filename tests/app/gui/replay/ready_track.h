// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>

#include "session/track/session_track.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth::test {

inline constexpr double kTick = 1.0 / 1024;  // s; sums are exact

/// A track without cuts: `ready` ticks of a recording of `seconds`. `touch`: the moment from which on the instrument
/// touches the tooth; 0: never.
inline std::shared_ptr<SessionTrack> trackOf(std::uint64_t ready, double seconds, std::uint64_t touch = 0) {
    auto tooth = LayeredTooth::make(box(Vec3(-1, -1, -1), Vec3(1, 1, 0)), {}, kDentin);
    const CutModel model(std::make_shared<const LayeredTooth>(std::move(*tooth)), 0.1);
    auto track = std::make_shared<SessionTrack>(model, seconds);
    for (std::uint64_t first = 0; first < ready; first += TrackChunk::kTicks) {
        TrackChunk chunk;
        for (std::uint64_t i = first; i < std::min(ready, first + TrackChunk::kTicks); ++i) {
            TrackTick tick;
            tick.time = kTick * static_cast<double>(i + 1);
            tick.depth = tick.time / 100;
            tick.contacts = touch > 0 && i + 1 >= touch ? 1 : 0;
            tick.force = {0, 0, tick.time};
            chunk.ticks.push_back(tick);
        }
        track->append(std::move(chunk));
    }
    return track;
}

}  // namespace tactooth::test
