// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/process/mirror_use.h"

#include <algorithm>

#include "assessment/messages.h"

namespace tactooth {
namespace {

constexpr double kLongestTick = 0.05;  // s: as in HandWorkMeter

}  // namespace

Measured mirrorTime(const SessionTrack* track) {
    if (track == nullptr) return Measured::none(msg::kNoSession);
    const std::vector<MirrorMoment> mirror = track->mirror();
    if (mirror.empty()) return Measured::none(msg::kNoMirrorKnown);
    double time = 0, last = 0;
    bool wasShown = false;
    std::uint64_t before = 0;  // ticks
    std::size_t next = 0;      // of `mirror`
    track->forEachTick(0, track->ticks(), [&](const TrackTick& tick) {
        if (wasShown) time += std::clamp(tick.time - last, 0.0, kLongestTick);
        while (next < mirror.size() && mirror[next].tick <= before) ++next;
        const Vec3 tip(tick.position[0], tick.position[1], tick.position[2]);
        wasShown = tick.placed && next > 0 && mirror[next - 1].sight.shows(tip);
        last = tick.time;
        ++before;
    });
    return Measured::of(time);
}

}  // namespace tactooth
