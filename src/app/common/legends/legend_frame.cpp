// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/legends/legend_frame.h"

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/common/images/image_view.h"
#include "app/common/offscreen_application.h"

namespace tactooth {

LegendFrame drawLegendFrame(QPainter& painter, const QRectF& box) {
    painter.setRenderHint(QPainter::Antialiasing);
    const double unit = box.height() / 8;  // a line of text takes two units
    QFont font = painter.font();
    font.setPixelSize(std::max(1, static_cast<int>(std::lround(1.6 * unit))));
    painter.setFont(font);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 26, 32, 190));
    painter.drawRoundedRect(box, unit / 2, unit / 2);
    painter.setPen(Qt::white);
    LegendFrame frame;
    frame.bar = QRectF(box.x() + unit, box.y() + 3.2 * unit, box.width() - 2 * unit, 1.8 * unit);
    frame.above = QRectF(frame.bar.x(), box.y() + 0.6 * unit, frame.bar.width(), 2.2 * unit);
    frame.below = QRectF(frame.bar.x(), frame.bar.bottom() + 0.3 * unit, frame.bar.width(), 2.2 * unit);
    return frame;
}

void drawLegendInto(Image& image, const std::function<void(QPainter&, const QRectF&)>& draw) {
    const OffscreenApplication application;
    QImage canvas = viewOf(image);
    QPainter painter(&canvas);
    const double unit = std::max(1.0, image.size.height / 60.0);
    draw(painter, QRectF(1.5 * unit, image.size.height - 9.5 * unit, 30 * unit, 8 * unit));
}

}  // namespace tactooth
