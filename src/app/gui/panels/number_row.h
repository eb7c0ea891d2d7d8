// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QSlider>

namespace tactooth {

/// A slider and a number box that always show the same value.
class NumberRow final : public QObject {
    Q_OBJECT

public:
    struct Range {
        double low, high, step;
        int decimals;
        QString unit;  ///< begins with a space
    };

    /// Adds a row to `grid`: label, slider, box. The widget of the grid owns it.
    NumberRow(QGridLayout& grid, const QString& label, const Range& range, double value, const QString& tip);

    [[nodiscard]] double value() const { return box_->value(); }
    void setValue(double value) { box_->setValue(value); }
    void setEnabled(bool enabled);
    [[nodiscard]] QDoubleSpinBox& box() { return *box_; }

signals:
    void changed(double value);

private:
    QSlider* slider_;
    QDoubleSpinBox* box_;
};

}  // namespace tactooth
