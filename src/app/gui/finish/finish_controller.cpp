// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/finish/finish_controller.h"

#include <QAction>
#include <QMainWindow>
#include <QStandardPaths>
#include <utility>

#include "app/common/mouth_scene.h"
#include "app/gui/controllers/examination_controller.h"
#include "app/gui/controllers/exercise_controller.h"
#include "app/gui/controllers/file_dialogs.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/finish/hand_in_dialog.h"
#include "app/gui/finish/report_dialog.h"
#include "app/gui/model/current_work.h"
#include "app/gui/model/examination_mode.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/exercise_panel.h"
#include "app/gui/replay/replay_controller.h"
#include "app/gui/scene/session_scene.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/text/translation.h"

namespace tactooth {

FinishController::FinishController(const Parts& parts) : parts_(parts) {
    connect(parts_.panels.exercise->finishAction(), &QAction::triggered, this, &FinishController::finishOrContinue);
    connect(&parts_.replay, &ReplayController::left, this, &FinishController::leaveReplay);
    connect(parts_.panels.drill, &DrillBar::cuttingChanged, this, [this](bool cutting) {
        if (cutting && finished_ == nullptr) parts_.exercise.continueClock();  // what is cut counts
    });
    followExercise();
}

FinishController::~FinishController() {
    if (progress_ != nullptr) progress_->stop();
}

std::optional<LongWork> FinishController::assessing() {
    if (!isAssessing()) return std::nullopt;
    return LongWork{.title = tr("Assessing"),
                    .share = progress_->share(),
                    .cancel = [this] { cancel(); },
                    .cancelTip = tr("The work goes on as if you had not finished it")};
}

void FinishController::finishOrContinue() {
    if (parts_.exercise.isClockStopped()) {
        parts_.exercise.continueClock();
        parts_.messages.setHint(tr("The time goes on."));
        return followExercise();
    }
    if (!obstacle().isEmpty()) return;
    if (!parts_.mode.isOn()) return begin(false);
    parts_.examinations.askToFinish([this] { begin(true); });
}

void FinishController::begin(bool isExamination) {
    isExamination_ = isExamination;
    assessment_.reset();
    FinishedWork work = takeWork();
    progress_ = std::make_shared<AssessmentProgress>();
    assessing_.start([work = std::move(work), progress = progress_] { return assessWork(work, *progress); });
    parts_.messages.setHint(tr("The time stands still. The work is being assessed…"));
    followExercise();
}

/// Ends the work, and takes it as it is then.
FinishedWork FinishController::takeWork() {
    stopWork();
    const SessionTooth& tooth = *parts_.model.tooth();
    const SessionWork now =
        currentWork(parts_.model, parts_.exercise.active(), parts_.exercise.targetFile().toStdString());
    return {.exercise = parts_.exercise.active(),
            .title = tooth.name,
            .uncut = tooth.piece->volume().tooth(),
            .cut = tooth.piece->surface(),
            .makeToothFile = makingToothFile(workTextWithoutFolders(now)),
            .recording = parts_.model.writtenRecording(),
            .language = windowLanguage()};
}

/// It reads the tooth in the background, while nothing cuts it.
std::function<std::vector<std::byte>()> FinishController::makingToothFile(const std::string& work) {
    const auto isRead = std::make_shared<std::promise<void>>();
    toothIsRead_ = isRead->get_future();
    const SessionTooth& tooth = *parts_.model.tooth();
    return [isRead, piece = tooth.piece, provenance = savedNow(tooth.provenance), work] {
        std::vector<std::byte> bytes = toothFileBytes(*piece, provenance, work);
        isRead->set_value();
        return bytes;
    };
}

/// The picture stays while nothing runs behind it.
void FinishController::stopWork() {
    const SessionTooth& tooth = *parts_.model.tooth();
    finished_ = tooth.piece;
    parts_.exercise.stopClock();
    SceneContents still = sceneContents(parts_.model, true, true);
    parts_.model.setPaused(true);
    if (still.tooth == nullptr) {  // the end of an examination has stopped it
        still.tooth = tooth.piece->surface();
        still.around = shownAround(tooth.around);
    }
    parts_.panels.view->setContents([still](bool, bool) { return still; });
}

/// The simulation goes on, and the time stands still.
void FinishController::release() {
    if (toothIsRead_.valid()) toothIsRead_.wait();  // from now on it may be cut
    finished_.reset();
    assessment_.reset();
    replays_ = false;
    if (handIn_ != nullptr) {
        handIn_->disconnect(this);
        handIn_->close();
    }
    if (report_ != nullptr) report_->deleteLater();
    report_.clear();
    parts_.panels.view->setContents({});
    parts_.model.setPaused(false);
    followExercise();
}

void FinishController::goOn() {
    parts_.exercise.continueClock();
    release();
    parts_.messages.setHint(tr("The time goes on."));
}

void FinishController::cancel() {
    assessing_.cancel();
    progress_->stop();
    goOn();
}

void FinishController::poll() {
    const bool isOtherTooth = finished_ != nullptr && parts_.model.tooth()->piece != finished_;
    if (isOtherTooth) {
        assessing_.cancel();
        if (std::exchange(replays_, false)) parts_.replay.leave();
        release();
    }
    collectAssessment();
    followExercise();
}

void FinishController::collectAssessment() {
    auto result = assessing_.poll();
    if (!result || finished_ == nullptr) return;
    if (!*result) {
        parts_.messages.showError(result->error());
        return release();
    }
    assessment_ = std::move(**result);
    if (assessment_ == nullptr) return;
    if (isExamination_) {
        parts_.messages.setHint(tr("The examination is over."));
        return askForHandIn(tr("The examination is over: its recording is signed and closed. Hand in your work."));
    }
    showReport();
}

void FinishController::showReport() {
    if (report_ == nullptr) {
        report_ = new ReportDialog(assessment_, &parts_.window);
        connect(report_, &ReportDialog::againWanted, this, &FinishController::again);
        connect(report_, &ReportDialog::replayWanted, this, &FinishController::replayFrom);
        connect(report_, &ReportDialog::handInWanted, this, [this] {
            askForHandIn(
                tr("The report, the tooth and the recording of this work are written into a new folder. "
                   "Nothing is sent anywhere."));
        });
        connect(report_, &ReportDialog::continueWanted, this, &FinishController::goOn);
        connect(report_, &QDialog::rejected, this, &FinishController::closeReport);
    }
    report_->open();
    parts_.messages.setHint(tr("Finished: the time stands still."));
}

void FinishController::closeReport() {
    release();
    if (parts_.panels.drill->isCutting()) parts_.panels.drill->touchAction()->trigger();
    parts_.messages.setHint(tr("The time stands still until you choose Continue, or Cut."));
}

void FinishController::again() { parts_.exercise.start(parts_.exercise.active()); }

void FinishController::replayFrom(double time) {
    replays_ = true;
    report_->hide();
    parts_.replay.openAt(QString::fromStdString(assessment_->recording.string()), time);
}

void FinishController::leaveReplay() {
    if (!std::exchange(replays_, false) || report_ == nullptr) return;
    if (parts_.model.tooth()->piece == finished_) showReport();
}

void FinishController::askForHandIn(const QString& intro) {
    if (handIn_ != nullptr) return;
    QWidget* const parent = report_ != nullptr ? static_cast<QWidget*>(report_) : &parts_.window;
    const QString last = parts_.files.folder();
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    handIn_ = new HandInDialog(intro, last.isEmpty() ? documents : last, parent);
    connect(handIn_, &HandInDialog::wanted, this, &FinishController::writeHandIn);
    connect(handIn_, &QDialog::rejected, this, [this] {
        if (stopsHandIn_ != nullptr) *stopsHandIn_ = true;
        if (isExamination_) release();
    });
    handIn_->open();
}

void FinishController::writeHandIn() {
    handIn_->setWriting(true);
    const auto folder = std::make_shared<std::filesystem::path>();
    stopsHandIn_ = std::make_shared<std::atomic<bool>>(false);
    parts_.writer.write(
        [folder, stops = stopsHandIn_, assessment = assessment_,
         what = handIn_->handIn()](const GoesOn& goesOn) -> Expected<bool> {
            Expected<std::filesystem::path> made =
                handInWork(*assessment, what, [&](double share) { return goesOn(share) && !*stops; });
            if (!made) return Unexpected{made.error()};
            *folder = std::move(*made);
            return !folder->empty();
        },
        [this, folder](const Expected<bool>& written) {
            takeHandIn(written, QString::fromStdString(folder->string()));
        });
}

void FinishController::takeHandIn(const Expected<bool>& written, const QString& folder) {
    stopsHandIn_.reset();
    if (!written || !*written) {
        if (handIn_ != nullptr) handIn_->setWriting(false);
        return parts_.messages.showWritten(written, {});
    }
    if (handIn_ == nullptr || finished_ == nullptr) return parts_.messages.setHint(tr("Handed in: %1").arg(folder));
    parts_.files.enterFolderOf(folder);
    parts_.model.markSaved(finished_->removed());
    handIn_->accept();
    if (report_ != nullptr) report_->showHandedIn(folder);
    if (isExamination_) release();
    const QString sentence = tr("Handed in: %1").arg(folder);
    parts_.messages.setHint(sentence);
    if (isExamination_) parts_.messages.show(QMessageBox::Information, tr("Hand in"), sentence);
}

/// Why nothing can be finished now: a sentence; empty: it can.
QString FinishController::obstacle() const {
    if (parts_.exercise.active() == nullptr) {
        return tr("Choose an exercise first: without one there is nothing to compare the work with");
    }
    if (isAssessing()) return tr("The work is being assessed");
    if (finished_ != nullptr || parts_.replay.isActive()) return tr("Something else is shown in place of the tooth");
    if (parts_.model.runner() == nullptr) return tr("The tooth is not ready yet");
    return {};
}

void FinishController::followExercise() {
    const bool isStopped = finished_ == nullptr && parts_.exercise.isClockStopped();
    parts_.panels.exercise->showFinish(isStopped ? QString() : obstacle(), isStopped);
}

}  // namespace tactooth
