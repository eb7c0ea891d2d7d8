// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/exercise.h"
#include "session/hands/instrument_poses.h"

namespace tactooth {

/// The direction to look from at a planned cavity: the dentist's own one, or as far from it toward the axis of the
/// cavity as is needed to see its whole outline past the cusps, and to look into it. `tooth`: uncut;
/// `mesialX`: direction of mesial along x.
[[nodiscard]] ViewDirection viewOnto(const PreparationPlan& plan, const LayeredTooth& tooth, double mesialX);

}  // namespace tactooth
