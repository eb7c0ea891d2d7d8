// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "assessment/cause/error_patch.h"
#include "assessment/preparation/preparation_metrics.h"
#include "session/track/session_track.h"

namespace tactooth {

/// A place at which too much was removed, and how that came.
struct OverPreparation {
    const MessageText* wall;                 ///< "Buccal wall"; not null
    double depth;                            ///< beyond the ideal surface, mm
    double volume;                           ///< mm^3
    Vec3 place;                              ///< of the greatest depth, mm
    std::optional<double> moment = {};       ///< when the material there was removed, s since the session began
    std::optional<RemovalCause> cause = {};  ///< nothing without a session
};

/// Gives places to those of `results` that have none (placeErrors), and with a finished session moments and causes to
/// all that name something removed. Returns the largest over-preparations, the largest first. `track`: null without a
/// session.
[[nodiscard]] std::vector<OverPreparation> traceErrors(std::vector<MetricResult>& results,
                                                       const Preparation& preparation,
                                                       const PreparationMeasures& measures,
                                                       const std::shared_ptr<const SessionTrack>& track);
inline constexpr std::size_t kMostOverPreparations = 3;

}  // namespace tactooth
