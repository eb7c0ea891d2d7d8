// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>

#include "app/gui/editor/cavity_fields.h"
#include "app/gui/editor/ideal_box.h"
#include "app/gui/editor/task_fields.h"
#include "app/gui/editor/tooth_fields.h"

namespace tactooth {

/// The panel of the editor of exercises: its fields, or, while the teacher tries the exercise, the way back.
class EditorPanel final : public QStackedWidget {
    Q_OBJECT

public:
    EditorPanel();

    /// Shows a draft; `problem` as in `showProblem`.
    void show(const ExerciseDraft& draft, const QString& problem);
    /// Why the draft cannot be tried or saved; empty: it can.
    void showProblem(const QString& problem);
    [[nodiscard]] ToothFields& tooth() const { return *tooth_; }
    [[nodiscard]] IdealBox& ideal() const { return *ideal_; }
    /// Whether it shows the way back in place of the fields.
    void setTrying(bool tries) { setCurrentIndex(tries ? 1 : 0); }

signals:
    void edited(const QString& step, const ExerciseChange& change);
    void undoWanted();
    void redoWanted();
    void trialWanted();
    void returnWanted();
    void savingWanted();
    void closingWanted();

private:
    [[nodiscard]] QWidget* makeFields();
    [[nodiscard]] QWidget* makeWayBack();
    QPushButton* addButton(const QString& text, const char* name, const QString& tip);

    QLabel* problem_;
    IdealBox* ideal_;
    ToothFields* tooth_;
    CavityFields* cavity_;
    TaskFields* task_;
    QPushButton* undo_;
    QPushButton* redo_;
    QPushButton* try_;
    QPushButton* save_;
};

}  // namespace tactooth
