// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "haptics/latency_histogram.h"

namespace tactooth {

/// A histogram of durations from 1 us to 16 ms. Both axes are logarithmic, so that one late tick among a million is
/// visible. A line marks the period that no duration should reach.
class HistogramView final : public QWidget {
    Q_OBJECT

public:
    struct Series {
        QString name;
        QColor colour;
        LatencyCounts counts;
    };

    explicit HistogramView(QWidget* parent = nullptr);

    /// `period`: us.
    void show(std::vector<Series> series, double period);
    [[nodiscard]] QSize sizeHint() const override { return {320, 110}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QRectF field() const;
    [[nodiscard]] double placeOf(double microseconds) const;
    void drawSeries(QPainter& painter, const Series& series, double highest) const;
    void drawAxis(QPainter& painter) const;
    void drawNames(QPainter& painter) const;

    std::vector<Series> series_;
    double period_ = 1000;  // us
};

}  // namespace tactooth
