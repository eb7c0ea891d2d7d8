// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

#include "app/gui/menus/tooth_chart_entry.h"
#include "app/gui/settings/window_settings.h"

class QAction;
class QMainWindow;
class QMenu;
class QToolBar;

namespace tactooth {

class ExaminationController;
class ExerciseController;
class RecordingController;
class SessionModel;
class ToothController;

/// The menu of files with its tool bar, and the list of files that were opened last.
class FileMenu final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the menu.
    FileMenu(QMainWindow& window, QToolBar& bar, SessionModel& model, ToothController& teeth,
             ExerciseController& exercise, RecordingController& recordings, ExaminationController& examinations);

    /// Another tooth has come.
    void showTooth() { chart_.showTooth(); }
    void restore(const WindowSettings& settings);
    void store(WindowSettings& settings) const;
    /// What was opened, imported or saved last, as RecentFile::text, newest first.
    [[nodiscard]] const QStringList& recent() const { return recent_; }
    [[nodiscard]] QAction& quit() const { return *quit_; }

signals:
    /// The user wants to choose a recording to open.
    void recordingWanted();
    /// The user wants to change settings.
    void settingsWanted();
    /// The user wants to change keys.
    void keysWanted();

private:
    void build(QMainWindow& window, QToolBar& bar, RecordingController& recordings,
               ExaminationController& examinations);
    void addBuiltinTeeth(QMenu& menu);
    void remember(const QString& file);
    void setRecent(const QStringList& files);
    void fillRecent();
    void fillCase();

    SessionModel& model_;
    ToothController& teeth_;
    ExerciseController& exercise_;
    ToothChartEntry chart_;
    QAction* quit_ = nullptr;
    QMenu* recentMenu_ = nullptr;
    QMenu* caseMenu_ = nullptr;
    QStringList recent_;  // newest first
};

}  // namespace tactooth
