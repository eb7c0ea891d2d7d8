// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/pictures/render_command.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Draws the built-in mouth from the side that `options.view` names: front, right, left, upper or lower (the chewing
/// surfaces of one jaw), dentist, or "AZIMUTH,ELEVATION" in degrees (90,0 from the front).
[[nodiscard]] Expected<void> renderMouth(const RenderOptions& options);

}  // namespace tactooth
