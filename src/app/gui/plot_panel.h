// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/gui/tick_trace.h"

class QLineSeries;
class QValueAxis;

namespace tactooth {

/// Depth, speed and force over the last ten seconds.
class PlotPanel final : public QWidget {
    Q_OBJECT

public:
    explicit PlotPanel(QWidget* parent = nullptr);
    /// Costs nothing while nothing happens: flat lines are drawn once.
    void show(const TickTrace& trace);
    [[nodiscard]] QSize sizeHint() const override { return {900, 170}; }

private:
    struct Plot {
        QLineSeries* line;
        QValueAxis* time;
        QValueAxis* value;
        double smallestRange;  // of the value axis: noise must not fill the plot
    };
    Plot addPlot(const QString& title, const QColor& colour, double smallestRange);
    static void draw(Plot& plot, const TickTrace& trace, double TickTrace::Point::*what);

    Plot depth_, speed_, force_;
    bool quiet_ = false;  // what is drawn
};

}  // namespace tactooth
