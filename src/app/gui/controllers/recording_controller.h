// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>

#include "app/gui/controllers/window_panels.h"
#include "app/gui/settings/window_settings.h"
#include "session/recording/recording_folder.h"

class QAction;
class QLabel;
class QMenu;

namespace tactooth {

class ExaminationMode;
class ExerciseController;
class WindowMessages;

/// Keeps a recording of each session in the user's folder, as long as the user lets it: the switch in the menu, the
/// sign in the status line, and the tooth that is saved when a signal ends the program.
class RecordingController final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the controller. Nothing is recorded before `setFolder`.
    RecordingController(SessionModel& model, const ExaminationMode& mode, const WindowPanels& panels,
                        WindowMessages& messages, ExerciseController& exercise);

    /// Where recordings are kept; empty: nowhere.
    void setFolder(const std::filesystem::path& folder);
    [[nodiscard]] bool hasFolder() const { return !folder_.empty(); }
    /// Needs a folder.
    [[nodiscard]] RecordingFolder folder() const;
    /// Adds a submenu: the switch, the folder and its size.
    void addTo(QMenu& menu);

    void restore(const WindowSettings& settings);
    void store(WindowSettings& settings) const;

    /// Notes what the user is doing, and shows whether it is recorded. Call it some times a second.
    void update();
    /// Recording has stopped or could not begin: one sentence.
    void showFault(const Message& fault);
    /// After a fault it goes on in another file.
    void showResumed();

    /// The program ends without a question: saves a tooth with unsaved cuts into the folder, where the next start finds
    /// it, and ends the recording. It waits for the disk. The runner stops.
    void saveBeforeEnd();

private:
    void apply();
    void followExamination();
    void fillMenu();
    void openFolder();

    SessionModel& model_;
    const ExaminationMode& mode_;
    WindowMessages& messages_;
    ExerciseController& exercise_;
    QLabel* sign_;
    QMenu* menu_ = nullptr;
    QAction* switch_;
    QAction* place_;  // shows the folder and its size
    QAction* open_;
    std::filesystem::path folder_;
    double gigabytes_ = WindowSettings().recordingGigabytes;
    bool isEnded_ = false;
};

}  // namespace tactooth
