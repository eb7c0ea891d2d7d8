// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "view/render/image.h"

namespace tactooth {

/// Draws into the lower left corner of `image` which colour stands for which distance, from -range to range mm. Needs
/// no display.
void drawDistanceLegend(Image& image, double range);

}  // namespace tactooth
