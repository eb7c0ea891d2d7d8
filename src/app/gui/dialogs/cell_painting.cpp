// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/cell_painting.h"

#include <QPainter>

namespace tactooth {

bool isUnderMouse(const QStyleOptionViewItem& option) { return (option.state & QStyle::State_MouseOver) != 0; }

void paintHeading(QPainter& painter, const QStyleOptionViewItem& option, const QString& text) {
    QFont bold = option.font;
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(option.palette.color(QPalette::Active, QPalette::Text));
    painter.drawText(option.rect.adjusted(kCellPad, 0, -kCellPad, -2), Qt::AlignLeft | Qt::AlignBottom, text);
}

void paintCellGround(QPainter& painter, const QStyleOptionViewItem& option, bool isCurrent) {
    if (!isCurrent && !isUnderMouse(option)) return;
    QColor ground = option.palette.color(QPalette::Active, QPalette::Highlight);
    painter.setPen(isCurrent ? QPen(ground, 2) : QPen(Qt::NoPen));
    ground.setAlpha(isCurrent ? 70 : 30);
    painter.setBrush(ground);
    painter.drawRoundedRect(option.rect.adjusted(1, 1, -1, -1), kCellPad, kCellPad);
}

}  // namespace tactooth
