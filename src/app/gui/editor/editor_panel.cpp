// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/editor/editor_panel.h"

#include <QGridLayout>
#include <QVBoxLayout>

namespace tactooth {

EditorPanel::EditorPanel()
    : problem_(new QLabel),
      ideal_(new IdealBox),
      tooth_(new ToothFields),
      cavity_(new CavityFields),
      task_(new TaskFields),
      undo_(addButton(tr("Undo"), "editUndo", tr("Takes the last change back"))),
      redo_(addButton(tr("Redo"), "editRedo", tr("Makes it again"))),
      try_(addButton(tr("Try it"), "editTry", tr("Starts the exercise as a student sees it"))),
      save_(addButton(tr("Save…"), "editSave", tr("Writes the file of the exercise, and adds it to your own"))) {
    setObjectName("editorPanel");
    addWidget(makeFields());
    addWidget(makeWayBack());
    for (DraftFields* fields :
         {static_cast<DraftFields*>(tooth_), static_cast<DraftFields*>(cavity_), static_cast<DraftFields*>(task_)})
        connect(fields, &DraftFields::edited, this, &EditorPanel::edited);
    connect(undo_, &QPushButton::clicked, this, &EditorPanel::undoWanted);
    connect(redo_, &QPushButton::clicked, this, &EditorPanel::redoWanted);
    connect(try_, &QPushButton::clicked, this, &EditorPanel::trialWanted);
    connect(save_, &QPushButton::clicked, this, &EditorPanel::savingWanted);
}

QPushButton* EditorPanel::addButton(const QString& text, const char* name, const QString& tip) {
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    button->setToolTip(tip);
    return button;
}

QWidget* EditorPanel::makeFields() {
    problem_->setObjectName("editProblem");
    problem_->setWordWrap(true);
    problem_->setMinimumHeight(2 * fontMetrics().lineSpacing());  // so that the fields do not jump
    auto* close = addButton(tr("Close"), "editClose", tr("Leaves the editor; asks first if changes are not saved"));
    connect(close, &QPushButton::clicked, this, &EditorPanel::closingWanted);
    auto* buttons = new QGridLayout;
    buttons->addWidget(undo_, 0, 0);
    buttons->addWidget(redo_, 0, 1);
    buttons->addWidget(try_, 1, 0);
    buttons->addWidget(save_, 1, 1);
    buttons->addWidget(close, 0, 2, 2, 1);
    auto* fields = new QWidget;
    auto* column = new QVBoxLayout(fields);
    column->setContentsMargins(4, 4, 4, 4);
    column->addLayout(buttons);
    column->addWidget(problem_);
    column->addWidget(ideal_);
    column->addWidget(tooth_);
    column->addWidget(cavity_);
    column->addWidget(task_);
    column->addStretch();
    return fields;
}

QWidget* EditorPanel::makeWayBack() {
    auto* text = new QLabel(tr("You are trying the exercise as a student sees it. Nothing of what you cut is kept."));
    text->setWordWrap(true);
    auto* back = addButton(tr("Back to the editor"), "editBack", tr("The exercise is as you left it"));
    connect(back, &QPushButton::clicked, this, &EditorPanel::returnWanted);
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->addWidget(text);
    column->addWidget(back);
    column->addStretch();
    return page;
}

void EditorPanel::show(const ExerciseDraft& draft, const QString& problem) {
    for (DraftFields* fields :
         {static_cast<DraftFields*>(tooth_), static_cast<DraftFields*>(cavity_), static_cast<DraftFields*>(task_)})
        fields->show(draft);
    undo_->setEnabled(draft.canUndo());
    redo_->setEnabled(draft.canRedo());
    showProblem(problem);
}

void EditorPanel::showProblem(const QString& problem) {
    problem_->setText(problem.isEmpty() ? tr("The exercise is complete.") : problem);
    try_->setEnabled(problem.isEmpty());
    save_->setEnabled(problem.isEmpty());
}

}  // namespace tactooth
