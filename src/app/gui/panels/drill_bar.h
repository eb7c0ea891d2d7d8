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
    [[nodiscard]] QAction* undoAction() { return undo_; }
    [[nodiscard]] QAction* resetAction() { return reset_; }
    /// Shows what a device's button has chosen; emits nothing.
    void showCutting(bool cutting);
    [[nodiscard]] bool isCutting() const { return cut_->isChecked(); }
    /// In the catalogue; empty for a bur from a file.
    [[nodiscard]] QString burNumber() const { return burs_->currentData().toString(); }
    [[nodiscard]] QString spindleName() const { return spindles_->currentData().toString(); }
    /// As if a person had chosen them; what is not in the lists is passed over.
    void choose(const QString& burNumber, const QString& spindleName);
    /// The list shows what is in the handpiece: a bur of the catalogue or, below them, the one of a file.
    void show(const QString& name, const QString& file);

signals:
    void burChosen(const BurSpec& spec);
    void burFileChosen(const QString& file);
    void spindleChosen(const SpindlePreset& spindle);
    void cuttingChanged(bool cutting);

private:
    void addModes();

    QComboBox* burs_;
    QComboBox* spindles_;
    QAction* touch_;
    QAction* cut_;
    QAction* undo_;
    QAction* reset_;
    bool showing_ = false;  // a choice that was made elsewhere
};

}  // namespace tactooth
