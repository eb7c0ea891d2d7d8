// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/second_view_frame.h"

#include <QPainter>

#include "app/gui/scene/corner_geometry.h"
#include "view/camera/second_view.h"

namespace tactooth {
namespace {

const QColor kLine(235, 240, 245, 200);  // visible on dark and bright parts of the picture
constexpr int kPad = 5;

}  // namespace

SecondViewFrame::SecondViewFrame(QWidget* parent) : QAbstractButton(parent) {
    setObjectName("secondViewFrame");
    setFocusPolicy(Qt::NoFocus);  // the tooth view receives the keys
    setCursor(Qt::PointingHandCursor);
    setToolTip(tr("Click: the large picture looks from there"));
}

void SecondViewFrame::fitTo(ImageSize picture) {
    setGeometry(cornerGeometry(secondViewRectangle(picture), devicePixelRatioF()));
}

void SecondViewFrame::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(kLine);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    const QRect text = fontMetrics().boundingRect(this->text()).adjusted(-kPad, -kPad / 2, kPad, kPad / 2);
    const QRect ground(1, 1, text.width(), text.height());
    painter.fillRect(ground, QColor(0, 0, 0, 130));
    painter.drawText(ground, Qt::AlignCenter, this->text());
}

}  // namespace tactooth
