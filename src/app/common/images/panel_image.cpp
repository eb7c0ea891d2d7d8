// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/images/panel_image.h"

#include <QChart>
#include <QChartView>
#include <QGraphicsLayout>
#include <QImage>
#include <QLegend>
#include <QLineSeries>
#include <QLogValueAxis>
#include <QPainter>
#include <QValueAxis>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/common/offscreen_application.h"

namespace tactooth {
namespace {

constexpr int kWidth = 1400;  // of the whole picture, pixels
constexpr int kWideHeight = 520;
constexpr int kNarrowHeight = 380;

/// Distinct on white, also for people who confuse red and green (after M. Okabe, K. Ito, "Color Universal Design").
const std::array<QColor, 6> kColours = {QColor(0x00, 0x72, 0xb2), QColor(0xd5, 0x5e, 0x00), QColor(0x00, 0x9e, 0x73),
                                        QColor(0xcc, 0x79, 0xa7), QColor(0xe6, 0x9f, 0x00), QColor(0x56, 0xb4, 0xe9)};
const QColor kReference(0x60, 0x60, 0x60);  // of dashed curves

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void take(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

Range rangeOf(const ExperimentPlot& panel, int coordinate) {
    Range range;
    for (const PlotSeries& series : panel.series) {
        for (const auto& point : series.points) range.take(point[static_cast<std::size_t>(coordinate)]);
    }
    if (range.low > range.high) range = {0, 1};
    return range;
}

QAbstractAxis* logAxis(Range range) {
    auto* axis = new QLogValueAxis;  // the chart takes ownership
    axis->setBase(10);
    axis->setLabelFormat("%.10g");
    axis->setMinorTickCount(8);
    axis->setMinorGridLineColor(QColor(0xf0, 0xf0, 0xf0));
    const double low = std::pow(10, std::floor(std::log10(range.low) + 1e-9));
    const double high = std::pow(10, std::ceil(std::log10(range.high) - 1e-9));
    axis->setRange(low, high > low ? high : 10 * low);
    return axis;
}

/// A round number (1, 2 or 5 times a power of ten) that divides `length` into four to ten parts.
double roundInterval(double length) {
    const double power = std::pow(10, std::floor(std::log10(length / 4)));
    const double parts = length / 4 / power;
    return (parts >= 5 ? 5 : parts >= 2 ? 2 : 1) * power;
}

/// Starts at zero, or at the lowest value if that is negative. `closed` ends the axis at a tick with room for the
/// curve.
QAbstractAxis* linearAxis(Range range, bool closed) {
    auto* axis = new QValueAxis;  // the chart takes ownership
    axis->setLabelFormat("%.10g");
    const double low = std::min(0.0, range.low);
    const double high = std::max(range.high, low) > low ? range.high : low + 1;
    const double interval = roundInterval(high - low);
    if (closed) {
        constexpr double kRoom = 0.02;  // as a share of an interval
        const int below = static_cast<int>(std::ceil(-low / interval - kRoom));
        const int above = static_cast<int>(std::ceil(high / interval + kRoom));
        axis->setRange(-below * interval, above * interval);
        axis->setTickCount(below + above + 1);
    } else {
        axis->setRange(low, high);
        axis->setTickType(QValueAxis::TicksDynamic);
        axis->setTickInterval(interval);
    }
    return axis;
}

QAbstractAxis* axisOf(const ExperimentPlot& panel, int coordinate) {
    const bool isLog = coordinate == 0 ? panel.logX : panel.logY;
    const Range range = rangeOf(panel, coordinate);
    QAbstractAxis* axis = isLog ? logAxis(range) : linearAxis(range, coordinate == 1);
    axis->setTitleText(QString::fromStdString(coordinate == 0 ? panel.xTitle : panel.yTitle));
    axis->setGridLineColor(QColor(0xdc, 0xdc, 0xdc));
    return axis;
}

QLineSeries* curveOf(const PlotSeries& from, const QColor& colour) {
    auto* curve = new QLineSeries;  // the chart takes ownership
    curve->setName(QString::fromStdString(from.name));
    for (const auto& [x, y] : from.points) curve->append(x, y);
    curve->setPen(QPen(from.dashed ? kReference : colour, 2, from.dashed ? Qt::DashLine : Qt::SolidLine));
    curve->setMarkerSize(5);
    curve->setPointsVisible(from.marked);
    return curve;
}

QPixmap drawPanel(const ExperimentPlot& panel, int width, int height) {
    auto* chart = new QChart;  // the view takes ownership
    chart->setTitle(QString::fromStdString(panel.title));
    QFont title = chart->titleFont();
    title.setBold(true);
    chart->setTitleFont(title);
    chart->setMargins(QMargins(8, 4, 20, 4));
    chart->setBackgroundRoundness(0);
    chart->layout()->setContentsMargins(0, 0, 0, 0);
    QAbstractAxis* x = axisOf(panel, 0);
    QAbstractAxis* y = axisOf(panel, 1);
    chart->addAxis(x, Qt::AlignBottom);
    chart->addAxis(y, Qt::AlignLeft);
    std::size_t colour = 0;
    for (const PlotSeries& series : panel.series) {
        QLineSeries* curve = curveOf(series, kColours[colour % kColours.size()]);
        if (!series.dashed) ++colour;
        chart->addSeries(curve);
        curve->attachAxis(x);
        curve->attachAxis(y);
    }
    chart->legend()->setVisible(panel.series.size() > 1);
    chart->legend()->setAlignment(Qt::AlignBottom);
    chart->legend()->setMarkerShape(QLegend::MarkerShapeFromSeries);
    QChartView view(chart);
    view.setRenderHint(QPainter::Antialiasing);
    view.setFrameShape(QFrame::NoFrame);
    view.setBackgroundBrush(Qt::white);
    view.resize(width, height);
    return view.grab();
}

}  // namespace

Expected<void> writePanels(const Experiment& experiment, const std::filesystem::path& path) {
    const OffscreenApplication application;
    const int columns = experiment.plotColumns;
    const int count = static_cast<int>(experiment.panels.size());
    const int width = kWidth / columns;
    const int height = columns == 1 ? kWideHeight : kNarrowHeight;
    QImage image(kWidth, height * ((count + columns - 1) / columns), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    for (int i = 0; i < count; ++i) {
        const ExperimentPlot& panel = experiment.panels[static_cast<std::size_t>(i)];
        painter.drawPixmap(i % columns * width, i / columns * height, drawPanel(panel, width, height));
    }
    painter.end();
    return savePng(image, path);
}

}  // namespace tactooth
