// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/dial_gauge.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace tactooth {
namespace {

constexpr double kStart = 220, kSpan = 260;  // degrees, clockwise from the bottom left

QString figures(double value, int decimals) { return QLocale().toString(value, 'f', decimals); }

}  // namespace

DialGauge::DialGauge(Face face, QWidget* parent) : QWidget(parent), face_(std::move(face)) {
    setAccessibleName(face_.name);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

double DialGauge::fontScale() const {
    constexpr double kUsualLine = 16;  // pixels
    return std::max(1.0, fontMetrics().height() / kUsualLine);
}

void DialGauge::setLargest(double largest) {
    face_.largest = largest;
    update();
}

void DialGauge::setValue(double value) {
    const double step = std::pow(10.0, -face_.decimals);
    const double shown = std::round(value / step) * step;
    if (shown == value_) return;
    value_ = shown;
    update();
}

void DialGauge::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double side = std::min<double>(width(), height() * 1.12) - 12;
    const QRectF circle((width() - side) / 2, 7, side, side);
    const auto arc = [&](double from, double to, const QColor& colour, double thickness) {
        painter.setPen(QPen(colour, thickness, Qt::SolidLine, Qt::FlatCap));
        painter.drawArc(circle, static_cast<int>((kStart - kSpan * from) * 16),
                        static_cast<int>(-kSpan * (to - from) * 16));
    };
    const double share = std::clamp(value_ / face_.largest, 0.0, 1.0);
    const double warn = std::clamp(face_.warnFrom / face_.largest, 0.0, 1.0);
    constexpr double kThickness = 9;
    arc(0, 1, palette().color(QPalette::Midlight), kThickness);
    arc(0, std::min(share, warn), palette().color(QPalette::Highlight), kThickness);
    if (share > warn) arc(warn, share, QColor(200, 60, 40), kThickness);

    painter.setPen(palette().color(QPalette::WindowText));
    QFont large = font();
    large.setPointSizeF(font().pointSizeF() * 1.5);
    large.setBold(true);
    painter.setFont(large);
    painter.drawText(circle.adjusted(0, -6, 0, -6), Qt::AlignCenter, figures(value_, face_.decimals));
    painter.setFont(font());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const double below = 0.5 * (QFontMetricsF(large).height() + painter.fontMetrics().height()) - 6;
    painter.drawText(circle.translated(0, below), Qt::AlignCenter, face_.unit);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(0, 0, 0, -2), Qt::AlignHCenter | Qt::AlignBottom, face_.name);
}

}  // namespace tactooth
