// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "assessment/preparation/preparation_metrics.h"
#include "session/track/track_tooth.h"

namespace tactooth {

/// When the material at a place of the cut surface was removed, s since the session began; nothing where nothing was
/// removed during the session. `outward`: unit, out of the remaining tooth. `tooth` is moved.
[[nodiscard]] std::optional<double> removalMoment(const SessionTrack& track, TrackTooth& tooth, const Vec3& place,
                                                  const Vec3& outward);

/// Adds the moments and causes of what a student has removed at the places of `results` that name a cut too deep or too
/// near: over-preparation, undercut, pulp and ridges. `track` is finished.
void addMoments(std::vector<MetricResult>& results, const Preparation& preparation, const PreparationMeasures& measures,
                const std::shared_ptr<const SessionTrack>& track);

}  // namespace tactooth
