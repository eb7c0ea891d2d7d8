// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QSlider>

namespace tactooth {

/// A number that can be set with a slider and typed into a box; both always agree.
class NumberRow final : public QObject {
    Q_OBJECT

public:
    struct Range {
        double low, high, step;
        int decimals;
        QString unit;  ///< with the space before it
    };

    /// Adds a row to `grid`: label, slider, box. Lives as long as the widget that the grid lays out.
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
