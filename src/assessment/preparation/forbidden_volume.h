// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/preparation/measured.h"
#include "assessment/preparation/preparation.h"

namespace tactooth {

/// What was removed below the outlines of the forbidden zones, seen along each one's direction, mm^3: the sum over the
/// zones. Nothing where there are none.
[[nodiscard]] Measured forbiddenVolume(const Preparation& preparation, const CutSurfaces& surfaces, double spacing);

}  // namespace tactooth
