// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "app/gui/dialogs/bur_grid.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace tactooth {

/// The grid of burs with its search. It closes when a bur is taken.
class BurDialog final : public QDialog {
    Q_OBJECT

public:
    /// `grid`: the dialog owns it.
    BurDialog(BurGrid* grid, QWidget* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] QWidget* makeHead();
    [[nodiscard]] QWidget* makeFoot();
    void filter();
    void showCurrent();

    BurGrid* grid_;
    QLineEdit* search_ = nullptr;
    QCheckBox* favouritesOnly_ = nullptr;
    QLabel* facts_ = nullptr;
    QPushButton* favourite_ = nullptr;
};

}  // namespace tactooth
