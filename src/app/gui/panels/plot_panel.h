// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QWidget>
#include <array>
#include <optional>

#include "app/gui/panels/tick_trace.h"

class QChart;
class QLineSeries;
class QSpinBox;
class QToolButton;
class QValueAxis;

namespace tactooth {

/// Cavity depth, penetration depth, speed and force over the last ten seconds.
class PlotPanel final : public QWidget {
    Q_OBJECT

public:
    explicit PlotPanel(QWidget* parent = nullptr);
    /// Draws flat lines only once, and nothing while the user has paused the plots.
    void show(const TickTrace& trace);
    /// A recording up to the time that is shown, or up to its end, which was `ago` s before that.
    struct Recorded {
        TickTrace trace;
        double ago = 0;
    };
    /// Two recordings, in colours of their own.
    void show(const Recorded& first, const Recorded& other);
    /// The trace that is drawn.
    [[nodiscard]] const TickTrace& shown() const { return shown_.trace; }
    /// Whether that is flat, so that it is not drawn again.
    [[nodiscard]] bool isFlat() const { return flat_; }
    /// That of the other recording, if there is one.
    [[nodiscard]] const std::optional<Recorded>& shownOther() const { return shownOther_; }
    [[nodiscard]] QWidget& plots() { return *plots_; }
    /// Takes over a changed palette or font.
    void setColours();
    [[nodiscard]] QSize sizeHint() const override { return {900, 170}; }

signals:
    void exportRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Plot {
        QLineSeries* line;
        QLineSeries* otherLine;  // without points while there is no other recording
        QColor colour;           // of a single line
        QValueAxis* time;
        QValueAxis* value;
        double smallestRange;  // of the value axis, so that noise does not fill the plot
        QChart* chart = nullptr;
    };
    static constexpr int kPlots = 4;
    QWidget* makeButtons();
    void setStretch(int seconds);
    void fitTicks();
    Plot addPlot(const QString& title, const QString& tip, const QColor& colour, double smallestRange);
    [[nodiscard]] std::array<Plot, kPlots> all() const { return {cavity_, depth_, speed_, force_}; }
    void drawAll();
    void draw(Plot& plot, double TickTrace::Point::*what) const;

    QWidget* plots_;
    QToolButton* pause_;
    QSpinBox* stretch_;  // s
    Plot cavity_, depth_, speed_, force_;
    Recorded shown_;
    std::optional<Recorded> shownOther_;
    bool flat_ = false;  // the drawn trace is flat
};

}  // namespace tactooth
