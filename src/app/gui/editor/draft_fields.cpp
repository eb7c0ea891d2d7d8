// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/editor/draft_fields.h"

#include <utility>

namespace tactooth {

QDoubleSpinBox* DraftFields::addNumber(const char* name, const QString& label, const Range& range,
                                       std::function<void(Exercise&, double)> set) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(name);
    box->setAccessibleName(label);
    box->setRange(range.low, range.high);
    box->setSingleStep(range.step);
    box->setDecimals(range.decimals);
    box->setSuffix(range.unit);
    box->setKeyboardTracking(false);
    form_->addRow(label, box);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, step = QString(name), set = std::move(set)](double value) {
        ask(step, [set, value](Exercise& exercise) { set(exercise, value); });
    });
    return box;
}

QComboBox* DraftFields::addChoice(const char* name, const QString& label, const QStringList& entries,
                                  std::function<void(Exercise&, int)> set) {
    auto* box = new QComboBox;
    box->setObjectName(name);
    box->setAccessibleName(label);
    box->addItems(entries);
    // The panel decides on the width, not the longest entry.
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(12);
    form_->addRow(label, box);
    connect(box, &QComboBox::currentIndexChanged, this, [this, set = std::move(set)](int entry) {
        ask({}, [set, entry](Exercise& exercise) { set(exercise, entry); });
    });
    return box;
}

}  // namespace tactooth
