// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/distance_legend.h"

#include <QImage>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/common/image_view.h"
#include "app/common/offscreen_application.h"
#include "view/mesh/distance_grid.h"

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
    painter.setRenderHint(QPainter::Antialiasing);
    const double unit = box.height() / 8;  // a line of text takes two units
    QFont font = painter.font();
    font.setPixelSize(std::max(1, static_cast<int>(std::lround(1.6 * unit))));
    painter.setFont(font);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 26, 32, 190));
    painter.drawRoundedRect(box, unit / 2, unit / 2);
    const QRectF bar(box.x() + unit, box.y() + 3.2 * unit, box.width() - 2 * unit, 1.8 * unit);
    drawRow(painter, bar, scale);
    painter.setPen(Qt::white);
    const QRectF above(bar.x(), box.y() + 0.6 * unit, bar.width(), 2.2 * unit);
    painter.drawText(above, Qt::AlignLeft | Qt::AlignVCenter, words.tooDeep);
    painter.drawText(above, Qt::AlignRight | Qt::AlignVCenter, words.stillToCut);
    const QRectF below(bar.x(), bar.bottom() + 0.3 * unit, bar.width(), 2.2 * unit);
    painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter, millimetres(QStringLiteral("\u2212"), scale.range));
    const bool hasBand = scale.tolerance > 0;
    painter.drawText(below, Qt::AlignHCenter | Qt::AlignVCenter,
                     hasBand ? words.within + millimetres(QStringLiteral(" \u00b1"), scale.tolerance) : "0");
    painter.drawText(below, Qt::AlignRight | Qt::AlignVCenter, millimetres("+", scale.range));
}

void drawDistanceLegend(Image& image, const DistanceScale& scale) {
    const OffscreenApplication application;
    QImage canvas = viewOf(image);
    QPainter painter(&canvas);
    const double unit = std::max(1.0, image.size.height / 60.0);
    drawDistanceLegend(painter, QRectF(1.5 * unit, image.size.height - 9.5 * unit, 30 * unit, 8 * unit), scale,
                       {"cut too deep", "still to cut", "within"});
}

}  // namespace tactooth
