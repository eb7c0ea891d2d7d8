// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/histogram_view.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace tactooth {
namespace {

constexpr int kOctaves = 14;  // from 1 us to 16.4 ms
constexpr int kPerOctave = 4;
constexpr int kBars = kOctaves * kPerOctave;

double startOf(int bar) { return std::exp2(static_cast<double>(bar) / kPerOctave); }

/// Values beyond an end of the axis count in its last bar.
std::uint64_t countIn(const LatencyCounts& counts, int bar) {
    return counts.between(bar == 0 ? 0 : startOf(bar), bar == kBars - 1 ? 1e300 : startOf(bar + 1));
}

double heightOf(std::uint64_t count) { return std::log10(1.0 + static_cast<double>(count)); }

}  // namespace

HistogramView::HistogramView(QWidget* parent) : QWidget(parent) { setMinimumSize(160, 70); }

void HistogramView::show(std::vector<Series> series, double period) {
    series_ = std::move(series);
    period_ = period;
    update();
}

QRectF HistogramView::field() const {
    const double line = fontMetrics().height();
    return {6, 4, width() - 12.0, height() - line - 8};
}

double HistogramView::placeOf(double microseconds) const {
    return field().left() + field().width() * std::log2(microseconds) / kOctaves;
}

/// Filled steps; the series behind stays visible.
void HistogramView::drawSeries(QPainter& painter, const Series& series, double highest) const {
    QPainterPath steps(field().bottomLeft());
    for (int bar = 0; bar < kBars; ++bar) {
        const double top = field().bottom() - field().height() * heightOf(countIn(series.counts, bar)) / highest;
        steps.lineTo(placeOf(startOf(bar)), top);
        steps.lineTo(placeOf(startOf(bar + 1)), top);
    }
    steps.lineTo(field().bottomRight());
    QColor filled = series.colour;
    filled.setAlphaF(0.35);
    painter.fillPath(steps, filled);
    painter.setPen(QPen(series.colour, 1.2));
    painter.drawPath(steps);
}

void HistogramView::drawAxis(QPainter& painter) const {
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawLine(field().bottomLeft(), field().bottomRight());
    const double line = fontMetrics().height();
    for (const double micros : {1.0, 10.0, 100.0, 1000.0, 10000.0}) {
        const double x = placeOf(micros);
        painter.setPen(palette().color(QPalette::Mid));
        painter.drawLine(QPointF(x, field().bottom()), QPointF(x, field().bottom() + 3));
        painter.setPen(palette().color(QPalette::WindowText));
        const QString text = micros < 1000 ? tr("%1 µs").arg(micros) : tr("%1 ms").arg(micros / 1000);
        const double wide = fontMetrics().horizontalAdvance(text);
        const double left = std::clamp(x - wide / 2, 0.0, width() - wide);
        painter.drawText(QRectF(left, field().bottom() + 3, wide + 1, line), Qt::AlignLeft, text);
    }
    painter.setPen(QPen(QColor(200, 60, 40), 1.4, Qt::DashLine));
    painter.drawLine(QPointF(placeOf(period_), field().top()), QPointF(placeOf(period_), field().bottom()));
}

/// On the right, where few ticks are.
void HistogramView::drawNames(QPainter& painter) const {
    const double line = fontMetrics().height();
    double widest = 0;
    for (const Series& series : series_) {
        widest = std::max<double>(widest, fontMetrics().horizontalAdvance(series.name));
    }
    const double left = field().right() - widest;
    double y = field().top();
    for (const Series& series : series_) {
        painter.fillRect(QRectF(left - 13, y + line / 2 - 4, 8, 8), series.colour);
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(QRectF(left, y, widest + 1, line), Qt::AlignLeft, series.name);
        y += line;
    }
}

void HistogramView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    double highest = heightOf(10);
    for (const Series& series : series_) {
        for (int bar = 0; bar < kBars; ++bar) highest = std::max(highest, heightOf(countIn(series.counts, bar)));
    }
    for (const Series& series : series_) drawSeries(painter, series, highest);
    drawAxis(painter);
    drawNames(painter);
}

}  // namespace tactooth
