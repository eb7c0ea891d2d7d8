// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "view/mesh/distance_colour.h"
#include "view/render/image.h"

class QPainter;
class QRectF;

namespace tactooth {

/// The words of a legend.
struct DistanceLegendWords {
    QString tooDeep, stillToCut, within;  ///< `within`: the tolerance
};

/// Draws the legend of the distance colours into `box`, which is about four times as wide as high.
void drawDistanceLegend(QPainter& painter, const QRectF& box, const DistanceScale& scale,
                        const DistanceLegendWords& words);

/// The same in English, in the lower left corner of `image`. Needs no display.
void drawDistanceLegend(Image& image, const DistanceScale& scale);

}  // namespace tactooth
