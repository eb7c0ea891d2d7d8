// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "assessment/preparation/measured.h"
#include "session/track/track_tooth.h"

namespace tactooth {

/// A piece of material that was removed.
struct RemovedPoint {
    Vec3 place;   ///< tooth frame, mm
    double size;  ///< its share of all, in any unit
};

/// When each point was removed, s since the session began, to `step` (s; 0: to the tick); nothing where it was not
/// removed during the session. `tooth` is moved.
inline constexpr double kCauseStep = 0.1;  ///< s
[[nodiscard]] std::vector<std::optional<double>> removalTimes(const SessionTrack& track, TrackTooth& tooth,
                                                              const std::vector<RemovedPoint>& points,
                                                              double step = kCauseStep);

/// How each error was made, in one walk through the track. The removals of an error are joined where the pauses between
/// them are shorter than half a second, and the piece of work that has removed most of it is the cause. Nothing for an
/// error of which no point was removed during the session. `axis`: of the preparation, unit, outward. After R. Yin et
/// al., Journal of Biomedical Informatics (2021), 103659: an error leads back to the piece of work that has made it.
[[nodiscard]] std::vector<std::optional<RemovalCause>> removalCauses(
    const SessionTrack& track, TrackTooth& tooth, const std::vector<std::vector<RemovedPoint>>& errors,
    const Vec3& axis);

}  // namespace tactooth
