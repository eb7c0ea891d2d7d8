// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QStringList>
#include <QWidget>
#include <array>
#include <map>

#include "app/gui/model/tooth_chart_layout.h"
#include "instruments/notation/tooth_notation.h"

namespace tactooth {

class ToothButton;

/// What the chart says about the teeth.
struct ToothChartMarks {
    int loaded = 0;                        ///< FDI number of the tooth on the bench; 0: it has none
    std::map<int, QStringList> exercises;  ///< names of the exercises for a tooth
};

/// The 32 permanent teeth to choose from, each a button with its number beside it. The arrow keys, Home, End and the
/// typed number go to a tooth; Enter chooses it.
class ToothChart final : public QWidget {
    Q_OBJECT

public:
    ToothChart(ToothChartMarks marks, ToothNotation notation, QWidget* parent = nullptr);

    void setNotation(ToothNotation notation);
    /// Gives the focus to a tooth.
    void goTo(int fdi);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void chosen(int fdi);
    /// The focus or the mouse is on this tooth: its name, number and exercises.
    void described(const QString& text);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void place();
    void nameButtons();
    [[nodiscard]] QString description(int fdi) const;
    [[nodiscard]] ToothButton& button(int fdi) const;
    [[nodiscard]] QPointF onWidget(const Vec2& place) const;
    [[nodiscard]] double pixelsPerMm() const;
    void type(const QString& letters);

    ToothChartLayout layout_;
    ToothChartMarks marks_;
    ToothNotation notation_;
    std::array<ToothButton*, ToothChartLayout::kTeeth> buttons_ = {};
    QString typed_;  // the letters of a number so far
    QElapsedTimer sinceTyped_;
};

}  // namespace tactooth
