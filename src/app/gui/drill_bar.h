// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QComboBox>
#include <QToolBar>

#include "instruments/bur_catalogue.h"
#include "instruments/spindle.h"

namespace tactooth {

/// Which bur in which drive, and what it does: touch or cut.
class DrillBar final : public QToolBar {
    Q_OBJECT

public:
    explicit DrillBar(QWidget* parent = nullptr);

    [[nodiscard]] QAction* touchAction() { return touch_; }
    [[nodiscard]] QAction* cutAction() { return cut_; }
    [[nodiscard]] QAction* resetAction() { return reset_; }
    [[nodiscard]] bool isCutting() const { return cut_->isChecked(); }
    /// The list shows the bur of a file that is not in the catalogue.
    void showOwnBur(const QString& name);

signals:
    void burChosen(const BurSpec& spec);
    void spindleChosen(const SpindlePreset& spindle);
    void cuttingChanged(bool cutting);

private:
    void addModes();

    QComboBox* burs_;
    QComboBox* spindles_;
    QAction* touch_;
    QAction* cut_;
    QAction* reset_;
};

}  // namespace tactooth
