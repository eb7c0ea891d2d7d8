// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/recording_controller.h"

#include <QAction>
#include <QDesktopServices>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QUrl>
#include <utility>

#include "app/gui/controllers/exercise_controller.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/icons/line_icon.h"
#include "app/gui/model/current_work.h"
#include "app/gui/model/examination_mode.h"
#include "app/gui/panels/status_line.h"
#include "app/gui/text/translation.h"
#include "geometry/files/atomic_file.h"
#include "session/model/session_model.h"

namespace tactooth {
namespace {

constexpr double kGigabyte = 1e9;

}  // namespace

RecordingController::RecordingController(SessionModel& model, const ExaminationMode& mode, const WindowPanels& panels,
                                         WindowMessages& messages, ExerciseController& exercise)
    : model_(model),
      mode_(mode),
      messages_(messages),
      exercise_(exercise),
      sign_(new QLabel(tr("● Recording"))),
      switch_(new QAction(tr("&Record sessions"), this)),
      place_(new QAction(this)),
      open_(new QAction(tr("&Open folder"), this)) {
    sign_->setObjectName("recordingSign");
    sign_->setToolTip(tr("This session is recorded on this computer, so that nothing is lost; see the menu File."));
    sign_->hide();
    panels.status->addPermanentWidget(sign_);
    switch_->setObjectName("recordSessions");
    switch_->setCheckable(true);
    switch_->setChecked(true);
    setLineIcon(*switch_, "recordings");
    setLineIcon(*open_, "folder");
    connect(switch_, &QAction::toggled, this, &RecordingController::apply);
    connect(&mode_, &ExaminationMode::changed, this, &RecordingController::followExamination);
    place_->setEnabled(false);
    open_->setObjectName("openRecordings");
    connect(open_, &QAction::triggered, this, &RecordingController::openFolder);
}

void RecordingController::addTo(QMenu& menu) {
    menu_ = menu.addMenu(tr("Recor&dings"));
    menu_->setObjectName("recordings");
    setLineIcon(*menu_->menuAction(), "recordings");
    menu_->addActions({switch_, place_, open_});
    connect(menu_, &QMenu::aboutToShow, this, &RecordingController::fillMenu);
    fillMenu();
}

void RecordingController::fillMenu() {
    if (!hasFolder()) {
        place_->setText(tr("No folder"));
    } else {
        const QString size = QLocale().formattedDataSize(static_cast<qint64>(folder().bytes()));
        place_->setText(tr("%1 in %2").arg(size, QString::fromStdString(folder_.string())));
    }
    open_->setEnabled(hasFolder());
    switch_->setEnabled(hasFolder() && !mode_.isOn());  // an examination is always recorded
}

void RecordingController::openFolder() {
    std::error_code ignored;
    std::filesystem::create_directories(folder_, ignored);
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(folder_.string())))) {
        messages_.setHint(tr("The recordings are in %1").arg(QString::fromStdString(folder_.string())));
    }
}

RecordingFolder RecordingController::folder() const {
    return RecordingFolder(folder_, static_cast<std::uint64_t>(kGigabyte * gigabytes_));
}

void RecordingController::setFolder(const std::filesystem::path& folder) {
    std::error_code ignored;
    folder_ = folder.empty() ? folder : std::filesystem::absolute(folder, ignored);
    fillMenu();
    apply();
}

void RecordingController::apply() {
    if (!hasFolder()) return;
    if (!switch_->isChecked() && !mode_.isOn()) {
        model_.stopRecording();
        return update();
    }
    model_.recordTo(folder(), mode_.seal());
    if (model_.tooth() && !model_.isRecording() && !model_.isPreparing()) {
        messages_.setHint(tr("Recording begins with the next tooth"));
    }
}

/// The recording of an examination ends with it, so that nothing of what comes later is signed.
void RecordingController::followExamination() {
    fillMenu();
    if (!mode_.isOn() && hasFolder()) model_.stopRecording();
    apply();
    update();
}

void RecordingController::restore(const WindowSettings& settings) {
    gigabytes_ = settings.recordingGigabytes;
    const QSignalBlocker blocked(switch_);
    switch_->setChecked(settings.recordsSessions);
    apply();
}

void RecordingController::store(WindowSettings& settings) const {
    settings.recordingGigabytes = gigabytes_;
    settings.recordsSessions = switch_->isChecked();
}

void RecordingController::update() {
    sign_->setText(model_.isSealing() ? tr("● Examination, signed") : tr("● Recording"));
    sign_->setVisible(model_.isRecording());
    if (!model_.tooth()) return;
    SessionWork work = currentWork(model_, exercise_.active(), exercise_.targetFile().toStdString());
    // What comes is in the recording itself.
    work.seconds = model_.tooth()->work.seconds;
    work.events = model_.tooth()->work.events;
    work.isUnsaved = model_.tooth()->wasUnsaved;
    model_.describeWork(workText(work));
}

void RecordingController::showFault(const Message& fault) {
    if (mode_.isOn()) {
        messages_.showError(fault);  // without its recording an examination is worth nothing
    } else {
        messages_.setHint(translated(fault));
    }
    update();
}

void RecordingController::showResumed() {
    messages_.setHint(tr("The session is recorded again, in another file"));
    update();
}

void RecordingController::saveBeforeEnd() {
    if (std::exchange(isEnded_, true)) return;
    const bool isModified = model_.isModified();
    SessionWork work = currentWork(model_, exercise_.active(), exercise_.targetFile().toStdString());
    model_.stop();  // first: the hand is let go
    if (hasFolder() && isModified) {
        work.isUnsaved = true;
        const std::vector<std::byte> bytes =
            toothFileBytes(*model_.tooth()->piece, savedNow(model_.tooth()->provenance), workText(work));
        const auto name = folder().autosaveName();
        if (name) (void)writeFile(*name, bytes).has_value();  // nobody is left to read a sentence
    }
    model_.finishRecording();
}

}  // namespace tactooth
