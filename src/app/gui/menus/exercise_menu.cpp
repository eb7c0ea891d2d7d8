// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/menus/exercise_menu.h"

#include <QMenu>
#include <QMenuBar>

#include "app/gui/controllers/exercise_controller.h"
#include "app/gui/icons/line_icon.h"
#include "app/gui/panels/exercise_panel.h"
#include "app/gui/text/translation.h"

namespace tactooth {

ExerciseMenu::ExerciseMenu(QMenuBar& bar, QAction& choice, ExerciseController& exercise, const ExercisePanel& panel)
    : exercise_(exercise) {
    QMenu* menu = bar.addMenu(tr("E&xercise"));
    menu->setObjectName("exerciseMenu");
    const auto add = [&](const QString& text, const char* name, const char* icon, const auto& act) {
        QAction* action = menu->addAction(text, this, act);
        action->setObjectName(name);
        setLineIcon(*action, icon);
    };
    add(tr("C&hoose an exercise…"), "chooseExercise", "exercise", [&choice] { choice.trigger(); });
    menu->addSeparator();
    add(tr("&New exercise…"), "newExercise", "new-exercise", &ExerciseMenu::newExerciseWanted);
    add(tr("Edit a &copy…"), "copyExerciseEntry", "edit-exercise", &ExerciseMenu::copyWanted);
    menu->addSeparator();
    own_ = menu->addMenu(tr("&Your own"));
    own_->setObjectName("ownExercises");
    setLineIcon(*own_->menuAction(), "exercise");
    connect(own_, &QMenu::aboutToShow, this, &ExerciseMenu::fillOwn);
    menu->addSeparator();
    menu->addAction(panel.finishAction());
}

void ExerciseMenu::fillOwn() {
    own_->clear();
    for (const auto& exercise : exercise_.known()) {
        if (exercise == nullptr || exercise->file.empty()) continue;
        QAction* action =
            own_->addAction(exerciseTitle(*exercise), this, [this, exercise] { exercise_.start(exercise); });
        action->setStatusTip(QString::fromStdString(exercise->file.string()));
        setLineIcon(*action, "exercise");
    }
    if (own_->isEmpty()) own_->addAction(tr("Nothing yet"))->setEnabled(false);
}

}  // namespace tactooth
