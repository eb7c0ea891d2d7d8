// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/legends/distance_legend.h"

#include <QLocale>
#include <QPainter>

#include "app/common/legends/legend_frame.h"
#include "view/mesh/distance_colour.h"

namespace tactooth {
namespace {

QColor colourAt(double share) {
    const Vec3f colour = distanceColour(share);
    return QColor::fromRgbF(colour.x(), colour.y(), colour.z());
}

void drawRow(QPainter& painter, const QRectF& bar, const DistanceScale& scale) {
    const int columns = static_cast<int>(bar.width());
    for (int x = 0; x < columns; ++x) {
        const double distance = scale.range * (2.0 * x / (columns - 1) - 1);
        painter.fillRect(QRectF(bar.x() + x, bar.y(), 1, bar.height()), colourAt(scale.shareOf(distance)));
    }
    painter.setPen(QColor(255, 255, 255, 120));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(bar);
}

QString millimetres(const QString& sign, double number) { return sign + QLocale().toString(number, 'g', 3) + " mm"; }

}  // namespace

void drawDistanceLegend(QPainter& painter, const QRectF& box, const DistanceScale& scale,
                        const DistanceLegendWords& words) {
    const auto [above, bar, below] = drawLegendFrame(painter, box);
    drawRow(painter, bar, scale);
    painter.setPen(Qt::white);
    painter.drawText(above, Qt::AlignLeft | Qt::AlignVCenter, words.tooDeep);
    painter.drawText(above, Qt::AlignRight | Qt::AlignVCenter, words.stillToCut);
    painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter, millimetres(QStringLiteral("\u2212"), scale.range));
    const bool hasBand = scale.tolerance > 0;
    painter.drawText(below, Qt::AlignHCenter | Qt::AlignVCenter,
                     hasBand ? words.within + millimetres(QStringLiteral(" \u00b1"), scale.tolerance) : "0");
    painter.drawText(below, Qt::AlignRight | Qt::AlignVCenter, millimetres("+", scale.range));
}

void drawDistanceLegend(Image& image, const DistanceScale& scale) {
    drawLegendInto(image, [&scale](QPainter& painter, const QRectF& box) {
        drawDistanceLegend(painter, box, scale, {"cut too deep", "still to cut", "within"});
    });
}

}  // namespace tactooth
