// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/distance_legend.h"

#include <QImage>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/common/offscreen_application.h"
#include "view/mesh/distance_grid.h"

namespace tactooth {
namespace {

QColor colourAt(double share) {
    const Vec3f colour = distanceColour(share);
    return QColor::fromRgbF(colour.x(), colour.y(), colour.z());
}

void drawRow(QPainter& painter, const QRectF& bar) {
    const int columns = static_cast<int>(bar.width());
    for (int x = 0; x < columns; ++x) {
        painter.fillRect(QRectF(bar.x() + x, bar.y(), 1, bar.height()), colourAt(2.0 * x / (columns - 1) - 1));
    }
    painter.setPen(QColor(255, 255, 255, 120));
    painter.drawRect(bar);
}

}  // namespace

void drawDistanceLegend(Image& image, double range) {
    const OffscreenApplication application;
    QImage canvas(reinterpret_cast<uchar*>(image.pixels.data()), image.size.width, image.size.height,
                  QImage::Format_RGBA8888);
    QPainter painter(&canvas);
    painter.setRenderHint(QPainter::Antialiasing);
    const double unit = std::max(1.0, image.size.height / 60.0);  // a line of text takes two units
    QFont font = painter.font();
    font.setPixelSize(static_cast<int>(std::lround(1.6 * unit)));
    painter.setFont(font);
    const QRectF box(1.5 * unit, image.size.height - 9.5 * unit, 30 * unit, 8 * unit);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 26, 32, 190));
    painter.drawRoundedRect(box, unit / 2, unit / 2);
    const QRectF bar(box.x() + unit, box.y() + 3.2 * unit, box.width() - 2 * unit, 1.8 * unit);
    drawRow(painter, bar);
    painter.setPen(Qt::white);
    const QRectF above(bar.x(), box.y() + 0.6 * unit, bar.width(), 2.2 * unit);
    painter.drawText(above, Qt::AlignLeft | Qt::AlignVCenter, "cut too deep");
    painter.drawText(above, Qt::AlignRight | Qt::AlignVCenter, "still to cut");
    const QRectF below(bar.x(), bar.bottom() + 0.3 * unit, bar.width(), 2.2 * unit);
    const QString number = QLocale().toString(range, 'g', 3);
    painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter, QStringLiteral("\u2212") + number + " mm");
    painter.drawText(below, Qt::AlignHCenter | Qt::AlignVCenter, "0");
    painter.drawText(below, Qt::AlignRight | Qt::AlignVCenter, "+" + number + " mm");
}

}  // namespace tactooth
