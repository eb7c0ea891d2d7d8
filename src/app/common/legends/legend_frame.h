// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <functional>

#include "view/render/image.h"

class QPainter;

namespace tactooth {

/// The parts of a legend of colours: a row of colours between two lines of text.
struct LegendFrame {
    QRectF above, bar, below;
};

/// Draws a dark plate over `box`, which is about four times as wide as high, and sets font and pen for the texts.
[[nodiscard]] LegendFrame drawLegendFrame(QPainter& painter, const QRectF& box);

/// Draws a legend into the lower left corner of `image`. Needs no display.
void drawLegendInto(Image& image, const std::function<void(QPainter&, const QRectF&)>& draw);

}  // namespace tactooth
