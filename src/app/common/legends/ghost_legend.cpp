// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/legends/ghost_legend.h"

#include <QLocale>
#include <QPainter>

#include "app/common/legends/legend_frame.h"
#include "view/scene/ghost_scale.h"

namespace tactooth {

void drawGhostLegend(QPainter& painter, const QRectF& box, const QString& title) {
    const LegendFrame frame = drawLegendFrame(painter, box);
    painter.drawText(frame.above, Qt::AlignLeft | Qt::AlignVCenter, title);
    const double width = frame.bar.width() / static_cast<double>(kGhostColours.size());
    for (std::size_t i = 0; i < kGhostColours.size(); ++i) {
        const Vec3f& colour = kGhostColours[i];
        const double left = frame.bar.x() + static_cast<double>(i) * width;
        painter.fillRect(QRectF(left, frame.bar.y(), width, frame.bar.height()),
                         QColor::fromRgbF(colour.x(), colour.y(), colour.z()));
        const QString border = QLocale().toString(static_cast<double>(i) * kGhostStep, 'g', 3);
        const QRectF text(left - width / 2, frame.below.y(), width, frame.below.height());
        if (i > 0) painter.drawText(text, Qt::AlignHCenter | Qt::AlignVCenter, border);
    }
    painter.drawText(frame.below, Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("mm"));
}

void drawGhostLegend(Image& image) {
    drawLegendInto(image, [](QPainter& painter, const QRectF& box) { drawGhostLegend(painter, box, "still to cut"); });
}

}  // namespace tactooth
