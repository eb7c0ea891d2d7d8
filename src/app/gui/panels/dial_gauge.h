// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace tactooth {

/// A dial gauge with a needle, the value in large figures, its unit and its name.
class DialGauge final : public QWidget {
    Q_OBJECT

public:
    struct Face {
        QString name;
        QString unit;
        double largest = 1;  ///< at the end of the scale, in `unit`
        int decimals = 0;
        double warnFrom = 1e9;  ///< the scale is red from this value on
    };
    explicit DialGauge(Face face, QWidget* parent = nullptr);

    void setLargest(double largest);
    void setValue(double value);
    [[nodiscard]] double value() const { return value_; }
    [[nodiscard]] QSize sizeHint() const override { return QSize(140, 128) * fontScale(); }
    [[nodiscard]] QSize minimumSizeHint() const override { return QSize(100, 110) * fontScale(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// The gauge grows with the font.
    [[nodiscard]] double fontScale() const;

    Face face_;
    double value_ = 0;
};

}  // namespace tactooth
