// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "app/gui/dialogs/tooth_chart.h"

class QComboBox;
class QLabel;

namespace tactooth {

/// The tooth chart with the choice of its numbers. It closes when a tooth is chosen.
class ToothChartDialog final : public QDialog {
    Q_OBJECT

public:
    ToothChartDialog(const ToothChartMarks& marks, ToothNotation notation, QWidget* parent);

signals:
    void chosen(int fdi);
    void notationChosen(ToothNotation notation);

private:
    [[nodiscard]] QWidget* makeHead(ToothNotation notation);
    [[nodiscard]] QWidget* makeLegend() const;

    ToothChart* chart_;
    QComboBox* notations_ = nullptr;
    QLabel* name_;
};

}  // namespace tactooth
