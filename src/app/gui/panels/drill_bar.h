// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QComboBox>
#include <QToolBar>
#include <functional>
#include <vector>

#include "app/gui/model/bur_list.h"
#include "instruments/bur_catalogue.h"
#include "instruments/spindle.h"

namespace tactooth {

class BurBox;

/// The tool bar of the drill: bur, spindle, and touch or cut.
class DrillBar final : public QToolBar {
    Q_OBJECT

public:
    explicit DrillBar(QWidget* parent = nullptr);

    [[nodiscard]] QAction* touchAction() { return touch_; }
    [[nodiscard]] QAction* cutAction() { return cut_; }
    [[nodiscard]] QAction* undoAction() { return undo_; }
    [[nodiscard]] QAction* redoAction() { return redo_; }
    [[nodiscard]] QAction* resetAction() { return reset_; }
    /// Shows touch or cut as a device's button has chosen it; emits nothing.
    void showCutting(bool cutting);
    [[nodiscard]] bool isCutting() const { return cut_->isChecked(); }
    /// All burs of its list; the place of each is its index.
    [[nodiscard]] std::vector<BurItem> burs() const;
    [[nodiscard]] int currentBur() const;
    /// Chooses a bur by its place in the list, as the user does; nothing where it is not allowed.
    void takeBur(int place);
    /// Number in the catalogue; empty for a bur from a file.
    [[nodiscard]] QString burNumber() const;
    [[nodiscard]] QString spindleName() const { return spindles_->currentData().toString(); }
    /// Chooses them as the user does; ignores what is not in the lists, or not allowed.
    void choose(const QString& burNumber, const QString& spindleName);
    /// By its number in the catalogue; by its file where that is not empty.
    using BurRule = std::function<bool(const QString& number, const QString& file)>;
    using DriveRule = std::function<bool(const SpindlePreset& drive)>;
    /// Offers only what these allow, and says at the rest why; without a rule all. What is chosen stays.
    void setAllowed(BurRule bur, const DriveRule& drive);
    /// Shows the bur in the handpiece: one of the catalogue or, below them, the one of a file.
    void show(const QString& name, const QString& file);

signals:
    /// The user wants to see all burs.
    void gridWanted();
    void burChosen(const BurSpec& spec);
    void burFileChosen(const QString& file);
    void spindleChosen(const SpindlePreset& spindle);
    void cuttingChanged(bool cutting);

private:
    void addModes();
    void showAllowed(int bur);

    BurBox* burs_;
    QComboBox* spindles_;
    QAction* touch_;
    QAction* cut_;
    QAction* undo_;
    QAction* redo_;
    QAction* reset_;
    BurRule allowsBur_;     // none: all
    bool showing_ = false;  // a choice that the user made elsewhere
};

}  // namespace tactooth
