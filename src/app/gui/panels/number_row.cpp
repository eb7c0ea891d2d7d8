// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/number_row.h"

#include <QLabel>
#include <cmath>

namespace tactooth {

NumberRow::NumberRow(QGridLayout& grid, const QString& label, const Range& range, double value, const QString& tip)
    : QObject(grid.parentWidget()), slider_(new QSlider(Qt::Horizontal)), box_(new QDoubleSpinBox) {
    const int row = grid.rowCount();
    auto* name = new QLabel(label);
    name->setBuddy(box_);
    grid.addWidget(name, row, 0);
    grid.addWidget(slider_, row, 1);
    grid.addWidget(box_, row, 2);
    box_->setRange(range.low, range.high);
    box_->setDecimals(range.decimals);
    box_->setSingleStep(range.step);
    box_->setSuffix(range.unit);
    box_->setKeyboardTracking(false);
    box_->setAccessibleName(label);
    slider_->setRange(static_cast<int>(std::lround(range.low / range.step)),
                      static_cast<int>(std::lround(range.high / range.step)));
    slider_->setMinimumWidth(60);
    for (QWidget* widget : {static_cast<QWidget*>(name), static_cast<QWidget*>(slider_), static_cast<QWidget*>(box_)}) {
        widget->setToolTip(tip);
    }
    connect(slider_, &QSlider::valueChanged, this, [this, step = range.step](int position) {
        if (std::abs(position * step - box_->value()) > step / 2) box_->setValue(position * step);
    });
    connect(box_, &QDoubleSpinBox::valueChanged, this, [this, step = range.step](double now) {
        slider_->setValue(static_cast<int>(std::lround(now / step)));
        emit changed(now);
    });
    box_->setValue(value);
}

void NumberRow::setEnabled(bool enabled) {
    slider_->setEnabled(enabled);
    box_->setEnabled(enabled);
}

}  // namespace tactooth
