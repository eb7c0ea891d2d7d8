// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <atomic>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>

#include "app/gui/controllers/window_panels.h"
#include "app/gui/finish/finished_work.h"
#include "app/gui/model/long_work.h"
#include "session/model/session_model.h"
#include "session/model/task.h"

class QMainWindow;

namespace tactooth {

class ExaminationController;
class ExaminationMode;
class ExerciseController;
class FileDialogs;
class FileWriter;
class HandInDialog;
class ReplayController;
class ReportDialog;
class WindowMessages;

/// *Finish*: stops the time of an exercise and its cutting, assesses the work in the background, and shows its report.
/// From there the student begins again, replays an error, hands in, or goes on. While the work is assessed and its
/// report is open, the simulation stands still.
class FinishController final : public QObject {
    Q_OBJECT

public:
    /// The parts of the window that it works with.
    struct Parts {
        QMainWindow& window;
        SessionModel& model;
        const ExaminationMode& mode;
        ExaminationController& examinations;
        WindowPanels panels;
        WindowMessages& messages;
        FileDialogs& files;
        FileWriter& writer;
        ExerciseController& exercise;
        ReplayController& replay;
    };
    /// All of them outlive the controller.
    explicit FinishController(const Parts& parts);
    ~FinishController() override;

    [[nodiscard]] bool isAssessing() const { return assessing_.isAwaited(); }
    /// The work while it is assessed.
    [[nodiscard]] std::optional<LongWork> assessing();
    /// The work goes on as if nobody had finished it.
    void cancel();
    /// Takes over what is ready, and follows the exercise. Call it after each step of the model.
    void poll();
    /// The newest report; null: there is none, or the work has gone on.
    [[nodiscard]] const std::shared_ptr<const WorkAssessment>& assessment() const { return assessment_; }

private:
    using Assessment = std::shared_ptr<const WorkAssessment>;

    void finishOrContinue();
    void begin(bool isExamination);
    [[nodiscard]] FinishedWork takeWork();
    [[nodiscard]] std::function<std::vector<std::byte>()> makingToothFile(const std::string& work);
    void stopWork();
    void goOn();
    void release();
    void collectAssessment();
    void takeHandIn(const Expected<bool>& written, const QString& folder);
    void showReport();
    void closeReport();
    void again();
    void replayFrom(double time);
    void leaveReplay();
    void askForHandIn(const QString& intro);
    void writeHandIn();
    void followExercise();
    [[nodiscard]] QString obstacle() const;

    Parts parts_;
    Task<Assessment> assessing_;
    std::shared_ptr<AssessmentProgress> progress_;
    std::future<void> toothIsRead_;                   // for its file
    std::shared_ptr<std::atomic<bool>> stopsHandIn_;  // while it is being written
    Assessment assessment_;
    std::shared_ptr<const CutModel> finished_;  // the tooth of the work; null: nothing is finished
    bool isExamination_ = false;                // the work that was finished
    bool replays_ = false;                      // an error
    QPointer<ReportDialog> report_;
    QPointer<HandInDialog> handIn_;
};

}  // namespace tactooth
