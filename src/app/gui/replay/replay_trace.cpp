// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/replay_trace.h"

namespace tactooth {

TickTrace traceBefore(const SessionTrack& track, std::uint64_t moment) {
    TickTrace trace;
    trace.setUncut(track.tooth()->outer());
    const double begin = track.tickBefore(moment).time - TickTrace::kShown - 2 * TickTrace::kInterval;
    std::array<Tick, 64> some;  // ticks are large
    std::size_t count = 0;
    track.forEachTick(track.momentAt(begin), moment, [&](const TrackTick& tick) {
        some[count++] = tick.tick();
        if (count == some.size()) trace.add(some), count = 0;
    });
    trace.add(std::span(some).first(count));
    return trace;
}

}  // namespace tactooth
