// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/util/pose.h"
#include "tooth/model/layered_tooth.h"
#include "tooth/sweep/revolution_envelope.h"

namespace tactooth {

/// mm: a millimetre of dentin shields the pulp; half of one barely does (Murray et al., "Pulp vitality and remaining
/// dentin thickness", 2003: reactions grow below 0.5 mm).
inline constexpr double kNearPulp = 1.0;
inline constexpr double kAtPulp = 0.5;

/// mm of tooth between the head of a bur at `pose` and the pulp, negative in the pulp; none: farther than `within` mm,
/// or no pulp.
[[nodiscard]] std::optional<double> distanceToPulp(const LayeredTooth& tooth, const RevolutionEnvelope& head,
                                                   const Pose& pose, double within);

/// Whether the wall of a pulp is nearer than `within` mm to the head of a bur at `pose`. Faster.
[[nodiscard]] bool isNearPulp(const LayeredTooth& tooth, const RevolutionEnvelope& head, const Pose& pose,
                              double within);

}  // namespace tactooth
