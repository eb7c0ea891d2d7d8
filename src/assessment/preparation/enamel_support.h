// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/preparation/measured.h"
#include "assessment/preparation/preparation.h"

namespace tactooth {

/// Area of the cut enamel that no dentin supports, mm^2: a line from there, square to the uncut surface and into the
/// tooth, leaves the prepared tooth before it meets dentin. Such enamel breaks under load. With the place of the
/// largest connected piece.
[[nodiscard]] Measured unsupportedEnamel(const Preparation& preparation, const CutSurfaces& surfaces);

}  // namespace tactooth
