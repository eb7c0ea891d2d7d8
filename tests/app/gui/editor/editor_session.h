// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QMessageBox>
#include <vector>

#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"

namespace tactooth::test {

/// A window in which a teacher makes an exercise by clicks alone.
class EditorSession : public WindowSession {
protected:
    /// Opens a window with settings of its own and waits for its tooth.
    void openEditorWindow();
    /// By mouse, as a user does.
    void chooseEntry(const char* menu, const char* entry);
    void click(const char* button) const;
    void clickAt(const QPoint& place) const { QTest::mouseClick(&view(), Qt::LeftButton, {}, place); }
    void waitForEditor();
    void setNumber(const char* name, double value) const;
    void answer(QMessageBox::StandardButton button) const;
    [[nodiscard]] const ExerciseDraft& draft() const { return *window_->editor().draft(); }
    [[nodiscard]] const PreparationPlan& plan() const { return *draft().plan(); }
    [[nodiscard]] const std::vector<Vec3>& points() const { return draft().points({}); }
    [[nodiscard]] QString problem() const { return window_->findChild<QLabel*>("editProblem")->text(); }
    /// Where a place of the tooth is in the picture.
    [[nodiscard]] QPoint pixelOf(const Vec3& place) const { return view().outlines().pointOf(place)->toPoint(); }
    [[nodiscard]] QMessageBox* question() const { return window_->findChild<QMessageBox*>("unsavedExercise"); }
};

}  // namespace tactooth::test
