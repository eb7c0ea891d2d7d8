// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/images/plot_image.h"

#include <QChart>
#include <QChartView>
#include <QImage>
#include <QLineSeries>
#include <QPainter>
#include <QValueAxis>
#include <algorithm>
#include <functional>

#include "app/common/messages.h"
#include "app/common/offscreen_application.h"

namespace tactooth {
namespace {

constexpr int kWidth = 1280;
constexpr int kPlotHeight = 280;
constexpr std::size_t kPointsShown = 1200;  // about one per pixel: the largest of the ticks between two points is shown

struct Plot {
    const char* title;
    const char* axis;
    QColor colour;
    std::function<double(const Tick&)> value;
};

QLineSeries* seriesOf(const Plot& plot, std::span<const Tick> ticks, double& largest) {
    auto* series = new QLineSeries;  // the chart takes ownership
    series->setPen(QPen(plot.colour, 1.8));
    const std::size_t stride = std::max<std::size_t>(1, ticks.size() / kPointsShown);
    for (std::size_t i = 0; i < ticks.size(); i += stride) {
        const auto some = ticks.subspan(i, std::min(stride, ticks.size() - i));
        double value = 0;
        for (const Tick& tick : some) value = std::max(value, plot.value(tick));
        series->append(some.front().time, value);
        largest = std::max(largest, value);
    }
    return series;
}

QValueAxis* axisTo(double largest, const QString& title) {
    auto* axis = new QValueAxis;
    axis->setRange(0, largest);
    axis->setTitleText(title);
    axis->setLabelFormat("%.3g");
    return axis;
}

void drawPlot(QPainter& painter, const Plot& plot, std::span<const Tick> ticks, int row, bool last) {
    auto* chart = new QChart;  // the view takes ownership
    chart->setTitle(plot.title);
    chart->setMargins(QMargins(4, 0, 16, 0));
    chart->legend()->hide();
    double largest = 0;
    QLineSeries* series = seriesOf(plot, ticks, largest);
    chart->addSeries(series);
    QValueAxis* time = axisTo(std::max(ticks.back().time, 1e-3), last ? "time, s" : "");
    QValueAxis* value = axisTo(largest > 0 ? 1.05 * largest : 1, plot.axis);
    value->applyNiceNumbers();
    chart->addAxis(time, Qt::AlignBottom);
    chart->addAxis(value, Qt::AlignLeft);
    series->attachAxis(time);
    series->attachAxis(value);
    QChartView view(chart);
    view.setRenderHint(QPainter::Antialiasing);
    view.setFrameShape(QFrame::NoFrame);
    view.resize(kWidth, kPlotHeight);
    painter.drawPixmap(0, row * kPlotHeight, view.grab());
}

}  // namespace

Expected<void> writeForcePlot(const std::filesystem::path& path, std::span<const Tick> ticks) {
    if (ticks.empty()) return unexpected(msg::kNothingToPlot);
    const OffscreenApplication application;
    const Plot plots[] = {
        {"Penetration depth: how far the hand is behind the surface", "mm", QColor(0x1b, 0x6c, 0xa8),
         [](const Tick& t) { return t.contact.depth; }},
        {"Speed of the tip", "mm/s", QColor(0x3c, 0x8d, 0x5a), [](const Tick& t) { return t.input.speed; }},
        {"Force on the hand", "N", QColor(0xb8, 0x4a, 0x32),
         [](const Tick& t) { return t.force.wrench.force.norm(); }}};
    QImage image(kWidth, 3 * kPlotHeight, QImage::Format_RGB32);
    QPainter painter(&image);
    for (int row = 0; row < 3; ++row) drawPlot(painter, plots[row], ticks, row, row == 2);
    painter.end();
    return savePng(image, path);
}

}  // namespace tactooth
