// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/preparation/preparation.h"

namespace tactooth {

// What a preparation needs besides its three surfaces.

/// Adds the pulps of `preparation.tooth`.
void addPulps(Preparation& preparation);

/// Adds the teeth beside, before the work (`uncut`) and as far as it has cut them (`cut`). `pose`: of the work in the
/// frame of the preparation.
void addNeighbours(Preparation& preparation, const LayeredTooth& uncut, const Surface& cut, const Pose& pose = {});

/// The direction of the tooth that comes nearest to that into which the ideal preparation opens.
[[nodiscard]] Vec3 openingOf(const Preparation& preparation);

}  // namespace tactooth
