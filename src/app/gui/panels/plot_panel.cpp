// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/plot_panel.h"

#include <QApplication>
#include <QChart>
#include <QChartView>
#include <QGraphicsLayout>
#include <QHBoxLayout>
#include <QLineSeries>
#include <QSpinBox>
#include <QToolButton>
#include <QValueAxis>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "app/gui/panels/plot_colours.h"

namespace tactooth {
namespace {

constexpr double kLineWidth = 1.6;  // pixels

void styleAxis(QValueAxis& axis) {
    QFont small = QApplication::font();
    small.setPointSizeF(small.pointSizeF() * 0.85);
    axis.setLabelsFont(small);
    axis.setGridLineColor(QApplication::palette().color(QPalette::Midlight));
    axis.setLinePenColor(QApplication::palette().color(QPalette::Mid));
    axis.setLabelsColor(QApplication::palette().color(QPalette::WindowText));
}

/// The next of 1, 2, 5, 10, ... that is not smaller, so that the axis does not change all the time.
double roundRange(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0, 10.0}) {
        if (value <= step * decade) return step * decade;
    }
    return value;
}

}  // namespace

PlotPanel::PlotPanel(QWidget* parent)
    : QWidget(parent), plots_(new QWidget), pause_(new QToolButton), stretch_(new QSpinBox) {
    auto* all = new QHBoxLayout(this);
    all->setContentsMargins(2, 2, 2, 2);
    all->setSpacing(2);
    all->addWidget(plots_, 1);
    all->addWidget(makeButtons());
    auto* row = new QHBoxLayout(plots_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    cavity_ =
        addPlot(tr("Cavity depth, mm"), tr("How deep the tip of the bur is below the uncut surface, along its shaft"),
                QColor(148, 82, 160), 0.5);
    depth_ = addPlot(tr("Penetration depth, mm"),
                     tr("How far the hand is behind the surface that the bur touches: it grows with the force"),
                     QColor(0, 114, 178), 0.2);
    speed_ = addPlot(tr("Speed, mm/s"), tr("Speed of the hand at the tip of the bur"), QColor(0, 158, 115), 10);
    force_ = addPlot(tr("Force, N"), tr("Force on the hand"), QColor(213, 94, 0), 0.5);
    setColours();
    setStretch(static_cast<int>(TickTrace::kShown));
}

QWidget* PlotPanel::makeButtons() {
    auto* side = new QWidget;
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(2, 2, 2, 2);
    pause_->setText(tr("Pause"));
    pause_->setCheckable(true);
    pause_->setToolTip(tr("Holds the plots still, to look at them or to export them; the simulation goes on"));
    pause_->setObjectName("pausePlots");
    auto* write = new QToolButton;
    write->setText(tr("Export…"));
    write->setToolTip(tr("Writes what is shown: a table (CSV) or a picture (PNG, SVG)"));
    write->setObjectName("exportPlots");
    stretch_->setRange(1, static_cast<int>(TickTrace::kShown));
    stretch_->setSuffix(tr(" s"));
    stretch_->setToolTip(tr("How much time is shown; the mouse wheel over a plot changes it too"));
    stretch_->setAccessibleName(tr("Time shown"));
    stretch_->setObjectName("plotStretch");
    for (QWidget* widget :
         {static_cast<QWidget*>(pause_), static_cast<QWidget*>(write), static_cast<QWidget*>(stretch_)}) {
        widget->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        column->addWidget(widget);
    }
    column->addStretch();
    connect(write, &QToolButton::clicked, this, &PlotPanel::exportRequested);
    connect(stretch_, &QSpinBox::valueChanged, this, &PlotPanel::setStretch);
    return side;
}

void PlotPanel::setStretch(int seconds) {
    stretch_->setValue(seconds);
    for (const Plot& plot : all()) plot.time->setRange(-seconds, 0);
    fitTicks();
}

/// Shows as many figures below a plot as fit.
void PlotPanel::fitTicks() {
    const int seconds = stretch_->value();
    const int letters = QFontMetrics(QApplication::font()).horizontalAdvance("-10 s") + 8;
    const int room = plots_->width() / kPlots / std::max(1, letters);
    const int wanted = seconds % 5 == 0 && room >= 6 ? 6 : seconds % 2 == 0 && room >= 3 ? 3 : 2;
    for (const Plot& plot : all()) plot.time->setTickCount(wanted);
}

void PlotPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitTicks();
}

/// Uses the program's palette: a hidden widget has not received a change yet.
void PlotPanel::setColours() {
    for (const Plot& plot : all()) {
        styleAxis(*plot.time);
        styleAxis(*plot.value);
        plot.chart->setTitleFont(QApplication::font());
        plot.chart->setTitleBrush(QApplication::palette().color(QPalette::WindowText));
        plot.chart->setBackgroundBrush(QApplication::palette().color(QPalette::Base));
    }
}

void PlotPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() != QEvent::FontChange) return;
    setColours();
    fitTicks();
}

/// The wheel over a plot changes its time range.
bool PlotPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Wheel) return QWidget::eventFilter(watched, event);
    stretch_->stepBy(static_cast<QWheelEvent*>(event)->angleDelta().y() > 0 ? -1 : 1);
    return true;
}

PlotPanel::Plot PlotPanel::addPlot(const QString& title, const QString& tip, const QColor& colour,
                                   double smallestRange) {
    auto* chart = new QChart;
    Plot plot{new QLineSeries, new QLineSeries, colour, new QValueAxis, new QValueAxis, smallestRange, chart};
    chart->addAxis(plot.time, Qt::AlignBottom);
    chart->addAxis(plot.value, Qt::AlignLeft);
    for (QLineSeries* line : {plot.otherLine, plot.line}) {
        chart->addSeries(line);
        line->attachAxis(plot.time);
        line->attachAxis(plot.value);
    }
    plot.otherLine->setPen(QPen(kOtherRecordingColour, kLineWidth));
    plot.time->setLabelFormat("%.4g s");
    plot.value->setRange(0, smallestRange);
    plot.value->setTickCount(3);
    plot.value->setLabelFormat("%.4g");
    chart->setTitle(title);
    chart->legend()->hide();
    chart->setMargins({4, 0, 8, 2});
    chart->setBackgroundRoundness(0);
    chart->layout()->setContentsMargins(0, 0, 0, 0);
    auto* view = new QChartView(chart);
    view->setRenderHint(QPainter::Antialiasing);
    view->setMinimumHeight(110);
    view->setToolTip(tip);
    view->setAccessibleName(title);
    view->viewport()->installEventFilter(this);
    plots_->layout()->addWidget(view);
    return plot;
}

void PlotPanel::draw(Plot& plot, double TickTrace::Point::*what) const {
    double largest = plot.smallestRange;
    const auto drawLine = [&](QLineSeries& line, const Recorded& recorded) {
        QList<QPointF> points;
        const auto& all = recorded.trace.points();
        const double now = all.empty() ? 0 : all.back().time + recorded.ago;
        for (const TickTrace::Point& point : all) {
            points.append(QPointF(point.time - now, point.*what));
            largest = std::max(largest, point.*what);
        }
        line.replace(points);
    };
    plot.line->setPen(QPen(shownOther_ ? kFirstRecordingColour : plot.colour, kLineWidth));
    drawLine(*plot.line, shown_);
    drawLine(*plot.otherLine, shownOther_.value_or(Recorded()));
    const double range = roundRange(largest);
    if (range != plot.value->max()) plot.value->setMax(range);
}

void PlotPanel::show(const TickTrace& trace) {
    if (pause_->isChecked()) return;
    const bool filled = !trace.points().empty() && trace.points().back().time > TickTrace::kShown;
    const bool isFlat = trace.isFlat() && filled && !shownOther_;
    if (std::exchange(flat_, isFlat) && flat_) return;
    shown_ = {trace};
    shownOther_.reset();
    drawAll();
}

void PlotPanel::show(const Recorded& first, const Recorded& other) {
    if (pause_->isChecked()) return;
    flat_ = false;
    shown_ = first;
    shownOther_ = other;
    drawAll();
}

void PlotPanel::drawAll() {
    draw(cavity_, &TickTrace::Point::cavityDepth);
    draw(depth_, &TickTrace::Point::depth);
    draw(speed_, &TickTrace::Point::speed);
    draw(force_, &TickTrace::Point::force);
}

}  // namespace tactooth
