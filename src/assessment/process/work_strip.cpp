// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/process/work_strip.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "collision/bvh/closest_point.h"
#include "geometry/util/assert.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

constexpr std::size_t kDepthsPerColumn = 2;

}  // namespace

WorkStrip workStrip(const SessionTrack& track, const SurfacePart& original, std::size_t columns, std::size_t mostMarks,
                    Language language) {
    TACTOOTH_ASSERT(columns > 0);
    WorkStrip strip{.seconds = track.seconds()};
    strip.columns.resize(columns);
    if (!(strip.seconds > 0)) return strip;
    const double perColumn = strip.seconds / static_cast<double>(columns);
    std::vector<Vec3> tips(columns * kDepthsPerColumn, Vec3::Constant(1e6));  // the last one of each part of a column
    track.forEachTick(0, track.ticks(), [&](const TrackTick& tick) {
        const double at = tick.time / perColumn;
        const auto column = std::min(columns - 1, static_cast<std::size_t>(std::max(0.0, at)));
        const double force = std::hypot(tick.force[0], tick.force[1], tick.force[2]);
        if (tick.contacts > 0) strip.columns[column].force = std::max(strip.columns[column].force, force);
        const auto part = static_cast<std::size_t>(std::max(0.0, at * kDepthsPerColumn));
        if (tick.placed) {
            tips[std::min(tips.size() - 1, part)] = {tick.position[0], tick.position[1], tick.position[2]};
        }
    });
    constexpr std::size_t kGrain = 16;
    constexpr double kFar = 1e5;  // mm: no tip was there
    std::vector<double> depths(tips.size());
    parallelFor(
        tips.size(),
        [&](std::size_t i) {
            if (tips[i].x() < kFar) depths[i] = std::max(0.0, -signedDistance(original, tips[i]));
        },
        kGrain);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        double& depth = strip.columns[i / kDepthsPerColumn].depth;
        depth = std::max(depth, depths[i]);
    }
    std::set<std::string_view> kinds;
    for (const TrackEvent& event : track.events()) {
        if (strip.marks.size() == mostMarks) break;
        if (kinds.insert(event.text->id).second)
            strip.marks.push_back({event.time, std::string(event.text->in(language))});
    }
    return strip;
}

}  // namespace tactooth
