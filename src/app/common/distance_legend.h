// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "view/render/image.h"

namespace tactooth {

/// Draws the legend of the distance colours, from -range to range mm, into the lower left corner of `image`. Needs no
/// display.
void drawDistanceLegend(Image& image, double range);

}  // namespace tactooth
