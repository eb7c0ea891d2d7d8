// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "view/render/image.h"

class QPainter;
class QRectF;

namespace tactooth {

/// Draws what the colours of the ghost mean (kGhostColours) into `box`, which is about four times as wide as high.
void drawGhostLegend(QPainter& painter, const QRectF& box, const QString& title);

/// The same in English, in the lower left corner of `image`. Needs no display.
void drawGhostLegend(Image& image);

}  // namespace tactooth
