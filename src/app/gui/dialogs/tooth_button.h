// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QPainterPath>
#include <optional>

#include "app/gui/model/tooth_chart_layout.h"

namespace tactooth {

/// One tooth of the chart: its outline with the number beside it.
class ToothButton final : public QAbstractButton {
    Q_OBJECT

public:
    /// `loaded`: it is on the bench; `hasExercise`: it gets a dot.
    ToothButton(int fdi, bool loaded, bool hasExercise, QWidget* parent);

    [[nodiscard]] int fdi() const { return fdi_; }
    /// Where it is drawn, in the frame of the parent, pixels. The number is the text of the button.
    void setShape(const QPainterPath& outline, const QPainterPath& lines, const QRectF& number);
    /// The middle of the tooth, in the frame of the button.
    [[nodiscard]] QPoint middle() const { return outline_.boundingRect().center().toPoint(); }

signals:
    void arrowPressed(ChartStep step);
    /// Home or End: the first or the last tooth of the row.
    void endPressed(bool last);
    void lettersTyped(const QString& letters);
    /// The focus or the mouse has come.
    void entered();

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    [[nodiscard]] bool hitButton(const QPoint& place) const override;

private:
    int fdi_;
    bool loaded_;
    bool hasExercise_;
    QPainterPath outline_, lines_;  // frame of the button
    QRectF number_;
};

}  // namespace tactooth
