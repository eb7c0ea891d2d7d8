// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/mirror_moments.h"

#include <algorithm>
#include <iterator>

namespace tactooth {

/// As with burs, what came just after the tick of a moment belongs to it.
MirrorSight sightAt(std::span<const MirrorMoment> moments, std::uint64_t ticks) {
    const auto later = std::ranges::upper_bound(moments, ticks, {}, &MirrorMoment::tick);
    return later == moments.begin() ? MirrorSight() : std::prev(later)->sight;
}

std::optional<Vec3> firstEye(std::span<const MirrorMoment> moments) {
    const auto first = std::ranges::find_if(moments, [](const MirrorMoment& each) { return each.sight.isShown; });
    if (first == moments.end()) return std::nullopt;
    return first->sight.eyePlace();
}

}  // namespace tactooth
