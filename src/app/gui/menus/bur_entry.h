// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <set>
#include <string>

#include "app/gui/icons/bur_picture.h"
#include "app/gui/settings/window_settings.h"

class QAction;
class QWidget;

namespace tactooth {

class DrillBar;
class ExerciseController;

/// Opens the grid of burs: from the menu, by a key, or from the drill bar. It keeps the favourites and the pictures.
class BurEntry final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive it; `window` is the parent of the grid.
    BurEntry(QWidget& window, DrillBar& drill, const ExerciseController& exercise);

    [[nodiscard]] QAction& action() const { return *action_; }
    void restore(const WindowSettings& settings);
    void store(WindowSettings& settings) const;

private:
    void open();

    QWidget& window_;
    DrillBar& drill_;
    const ExerciseController& exercise_;
    QAction* action_;
    std::set<std::string> favourites_;  // numbers
    BurPictures pictures_;
};

}  // namespace tactooth
