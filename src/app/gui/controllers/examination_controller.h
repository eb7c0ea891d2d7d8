// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMessageBox>
#include <QObject>
#include <QPointer>
#include <functional>

#include "app/gui/controllers/window_panels.h"
#include "app/gui/model/examination_mode.h"
#include "app/gui/settings/window_settings.h"

class QAction;
class QMenu;

namespace tactooth {

class DockLayout;
class ExerciseController;
class RecordingController;
class WindowMessages;

/// Begins and ends examinations, and shows the window as the ExaminationMode wants it.
class ExaminationController final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the controller; `window` is the parent of its question.
    ExaminationController(ExaminationMode& mode, SessionModel& model, const WindowPanels& panels, DockLayout& docks,
                          ExerciseController& exercise, RecordingController& recordings, WindowMessages& messages,
                          QWidget& window);

    /// Adds the entry that begins and finishes.
    void addTo(QMenu& menu);
    /// The panels as they were before the examination, which hides some.
    void store(WindowSettings& settings) const;
    /// Call it after the layout was reset: what an examination hides stays hidden.
    void followLayout();
    /// Asks whether the examination is to end. `then`: called when it has.
    void askToFinish(const std::function<void()>& then = {});

private:
    void askToBegin();
    void apply();
    void showDocks(bool visible) const;

    ExaminationMode& mode_;
    SessionModel& model_;
    WindowPanels panels_;
    DockLayout& docks_;
    ExerciseController& exercise_;
    RecordingController& recordings_;
    WindowMessages& messages_;
    QWidget& window_;
    QAction* entry_;
    QPointer<QMessageBox> question_;
    std::string docksBefore_;
};

}  // namespace tactooth
