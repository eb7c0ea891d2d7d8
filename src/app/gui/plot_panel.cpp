// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/plot_panel.h"

#include <QChart>
#include <QChartView>
#include <QGraphicsLayout>
#include <QHBoxLayout>
#include <QLineSeries>
#include <QValueAxis>
#include <algorithm>
#include <cmath>

namespace tactooth {
namespace {

void styleAxis(QValueAxis& axis, const QWidget& like) {
    QFont small = like.font();
    small.setPointSizeF(small.pointSizeF() * 0.85);
    axis.setLabelsFont(small);
    axis.setGridLineColor(like.palette().color(QPalette::Midlight));
    axis.setLinePenColor(like.palette().color(QPalette::Mid));
    axis.setLabelsColor(like.palette().color(QPalette::WindowText));
}

/// The next of 1, 2, 5, 10, ... that is not smaller: an axis that rests instead of trembling.
double roundRange(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0, 10.0}) {
        if (value <= step * decade) return step * decade;
    }
    return value;
}

}  // namespace

PlotPanel::PlotPanel(QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(2, 2, 2, 2);
    row->setSpacing(2);
    depth_ = addPlot(tr("Depth, mm"), QColor(0, 114, 178), 0.2);
    speed_ = addPlot(tr("Speed, mm/s"), QColor(0, 158, 115), 10);
    force_ = addPlot(tr("Force, N"), QColor(213, 94, 0), 0.5);
}

PlotPanel::Plot PlotPanel::addPlot(const QString& title, const QColor& colour, double smallestRange) {
    auto* chart = new QChart;
    Plot plot{new QLineSeries, new QValueAxis, new QValueAxis, smallestRange};
    plot.line->setPen(QPen(colour, 1.6));
    chart->addSeries(plot.line);
    chart->addAxis(plot.time, Qt::AlignBottom);
    chart->addAxis(plot.value, Qt::AlignLeft);
    plot.line->attachAxis(plot.time);
    plot.line->attachAxis(plot.value);
    styleAxis(*plot.time, *this);
    styleAxis(*plot.value, *this);
    plot.time->setRange(-TickTrace::kShown, 0);
    plot.time->setLabelFormat("%.0f s");
    plot.time->setTickCount(6);
    plot.value->setRange(0, smallestRange);
    plot.value->setTickCount(3);
    plot.value->setLabelFormat("%.4g");
    chart->setTitle(title);
    chart->setTitleBrush(palette().color(QPalette::WindowText));
    chart->legend()->hide();
    chart->setMargins({4, 0, 8, 2});
    chart->setBackgroundRoundness(0);
    chart->layout()->setContentsMargins(0, 0, 0, 0);
    chart->setBackgroundBrush(palette().color(QPalette::Base));
    auto* view = new QChartView(chart);
    view->setRenderHint(QPainter::Antialiasing);
    view->setMinimumHeight(110);
    layout()->addWidget(view);
    return plot;
}

void PlotPanel::draw(Plot& plot, const TickTrace& trace, double TickTrace::Point::*what) {
    QList<QPointF> points;
    double largest = plot.smallestRange;
    const double now = trace.points().empty() ? 0 : trace.points().back().time;
    for (const TickTrace::Point& point : trace.points()) {
        points.append(QPointF(point.time - now, point.*what));
        largest = std::max(largest, point.*what);
    }
    const double range = roundRange(largest);
    if (range != plot.value->max()) plot.value->setMax(range);
    plot.line->replace(points);
}

void PlotPanel::show(const TickTrace& trace) {
    const bool filled = !trace.points().empty() && trace.points().back().time > TickTrace::kShown;
    if (std::exchange(quiet_, trace.isQuiet() && filled) && quiet_) return;
    draw(depth_, trace, &TickTrace::Point::depth);
    draw(speed_, trace, &TickTrace::Point::speed);
    draw(force_, trace, &TickTrace::Point::force);
}

}  // namespace tactooth
