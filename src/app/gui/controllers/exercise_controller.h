// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <memory>

#include "app/gui/controllers/window_panels.h"
#include "app/gui/model/exercise_clock.h"
#include "app/gui/model/long_work.h"
#include "app/gui/model/progress_meter.h"
#include "app/gui/model/target.h"
#include "assessment/exercise.h"

namespace tactooth {

class ExaminationMode;
class FileDialogs;
class FileWriter;
class ToothController;
class WindowMessages;

/// What the student is to cut and how well it was cut: the exercise, the target shape, and the progress toward it.
class ExerciseController final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the controller.
    ExerciseController(SessionModel& model, const ExaminationMode& mode, const WindowPanels& panels,
                       WindowMessages& messages, FileDialogs& files, FileWriter& writer, ToothController& teeth);

    /// Loads tooth, bur and target of an exercise; null: free practice, on the tooth as it is.
    void start(const std::shared_ptr<const Exercise>& exercise);
    /// Starts the exercise that a file describes; shows a message if that fails.
    void open(const QString& file);
    /// Compares the tooth with the closed surface in `file`: colours it by the distance, and makes its ghost.
    void openTarget(const QString& file);
    /// Writes the report of the work in the background; shows a message if that fails.
    void exportReport(const QString& file);
    void askForExercise();
    /// Adds the exercises of the user's own folder to the list; the status line names a file that cannot be used.
    void addOwn();
    /// Adds one, or puts it in the place of the one from the same file.
    void add(const std::shared_ptr<const Exercise>& exercise);
    /// Takes one out of the list, unless it is active.
    void remove(const std::shared_ptr<const Exercise>& exercise);

    /// The target as another window takes it over.
    struct TargetState {
        Target target;  ///< empty: none, or not ready yet
        QString file;   ///< of the user's own target
    };
    [[nodiscard]] TargetState targetState() const;
    /// Of the user's own target, from the moment it is opened; empty: none.
    [[nodiscard]] const QString& targetFile() const { return openedFile_.isEmpty() ? targetFile_ : openedFile_; }
    /// Null: free practice.
    [[nodiscard]] const std::shared_ptr<const Exercise>& active() const { return active_; }
    /// All that the user can choose; the first is null: free practice.
    [[nodiscard]] const std::vector<std::shared_ptr<const Exercise>>& known() const;

    /// Another tooth has come: the target before does not fit it.
    void takeTooth();
    /// Shows the cavity of the tooth's exercise and prepares its target, or the own target that the tooth was saved
    /// with.
    void beginExercise();
    /// Goes on with the target of another window.
    void restore(TargetState state);
    /// Shows which exercise is active: another one could not be loaded.
    void showActive();
    /// A target that is being prepared. When it is cancelled, the one before stays.
    [[nodiscard]] std::optional<LongWork> preparing();
    [[nodiscard]] bool isBusy() const { return pendingTarget_.isAwaited(); }
    /// Takes over what is ready and measures the progress. Call it after each step of the model.
    void poll();
    void showProgress();
    /// The time of the exercise stands still until `continueClock`, or until another one begins.
    void stopClock();
    void continueClock();
    [[nodiscard]] bool isClockStopped() const { return clock_.isStopped(); }
    /// Shows the target, unless an examination hides it.
    void showTarget();

signals:
    /// There is another exercise, or none any more.
    void activeChanged();
    void fileOpened(const QString& file);

private:
    void showCavity();
    void showZones();
    void prepareHand();
    void loadIdealShape();
    void setTarget(Target target);
    void clearTarget();
    void prepare(std::function<Expected<Target>(const TargetProgress& progress)> make);
    void cancelPreparing();
    void collectTarget();
    void leaveExercise();
    [[nodiscard]] double workSeconds() const;
    void askForTarget();
    void askForReportFile();

    SessionModel& model_;
    const ExaminationMode& mode_;
    WindowPanels panels_;
    WindowMessages& messages_;
    FileDialogs& files_;
    FileWriter& writer_;
    ToothController& teeth_;
    Task<Target> pendingTarget_;
    Target target_;                                  // of the tooth in the session; empty: none
    std::shared_ptr<std::atomic<double>> prepared_;  // the share of the pending target, 0..1
    QString targetFile_;                             // of the user's own target
    QString openedFile_;                             // of the user's own target that is pending
    std::shared_ptr<const Exercise> active_;         // null: free practice
    ProgressMeter progress_;
    ExerciseClock clock_;
};

}  // namespace tactooth
