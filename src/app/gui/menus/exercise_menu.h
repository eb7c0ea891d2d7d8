// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;
class QMenu;
class QMenuBar;

namespace tactooth {

class ExerciseController;
class ExercisePanel;

/// The menu of exercises: those of the user, and how to make one.
class ExerciseMenu final : public QObject {
    Q_OBJECT

public:
    /// Adds a menu to `bar`; all outlive the menu. `choice`: opens all exercises to choose from.
    ExerciseMenu(QMenuBar& bar, QAction& choice, ExerciseController& exercise, const ExercisePanel& panel);

signals:
    void newExerciseWanted();
    void copyWanted();

private:
    void fillOwn();

    ExerciseController& exercise_;
    QMenu* own_ = nullptr;
};

}  // namespace tactooth
