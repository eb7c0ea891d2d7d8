// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/restore_controller.h"

#include <QDateTime>
#include <QLocale>
#include <QPushButton>
#include <utility>

#include "app/gui/controllers/recording_controller.h"
#include "app/gui/controllers/tooth_controller.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/model/current_work.h"
#include "app/gui/text/translation.h"

namespace tactooth {
namespace {

/// The time alone on the same day, else with the date.
QString shortTime(std::chrono::system_clock::time_point time) {
    const QDateTime when = QDateTime::fromSecsSinceEpoch(std::chrono::system_clock::to_time_t(time));
    if (when.date() == QDate::currentDate()) return QLocale().toString(when.time(), QLocale::ShortFormat);
    return QLocale().toString(when, QLocale::ShortFormat);
}

}  // namespace

RestoreController::RestoreController(SessionModel& model, ToothController& teeth, RecordingController& recordings,
                                     WindowMessages& messages, QWidget& window)
    : model_(model), teeth_(teeth), recordings_(recordings), messages_(messages), window_(window) {
    connect(&teeth_, &ToothController::loadingFailed, this, &RestoreController::giveUp);
    connect(&teeth_, &ToothController::loadingDeclined, this, [this] {
        if (!teeth_.isBusy()) giveUp();  // else another tooth was declined
    });
}

RestoreController::~RestoreController() { giveUp(); }

/// The file stays, and the next start offers it again.
void RestoreController::giveUp() {
    if (const auto restoring = std::exchange(restoring_, nullptr)) restoring->progress->stops = true;
}

void RestoreController::offer() {
    if (!recordings_.hasFolder()) return;
    search_.start([folder = recordings_.folder()]() -> Expected<std::vector<Found>> {
        std::vector<Found> found;
        for (Leftover& leftover : folder.leftovers()) {
            if (auto facts = examine(leftover, folder)) found.push_back({std::move(leftover), std::move(*facts)});
        }
        return found;
    });
}

void RestoreController::poll() {
    if (auto found = search_.poll(); found && *found) {
        found_ = std::move(**found);
        askForNext();
    }
}

void RestoreController::askForNext() {
    if (found_.empty() || question_ != nullptr) return;
    const Found found = found_.front();
    found_.erase(found_.begin());
    const bool isCrash = found.leftover.kind() == Leftover::Kind::Recording;
    const QString name = translated(found.facts.title);
    question_ = new QMessageBox(QMessageBox::Question, tr("Unfinished session"),
                                tr("Restore the session of %1?").arg(shortTime(found.leftover.time())),
                                QMessageBox::NoButton, &window_);
    question_->setObjectName("restoreSession");
    question_->setAttribute(Qt::WA_DeleteOnClose);
    question_->setInformativeText(
        isCrash ? tr("Tactooth did not end as usual then. The tooth: %1").arg(name)
                : tr("The system closed Tactooth then, with unsaved cuts. The tooth: %1").arg(name));
    question_->setDefaultButton(question_->addButton(tr("&Restore"), QMessageBox::AcceptRole));
    question_->addButton(tr("&Keep the file"), QMessageBox::ActionRole)
        ->setToolTip(tr("It stays in the folder of recordings, and this question does not come again"));
    question_->addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    // The Esc key changes nothing: the next start asks again.
    auto* later = question_->addButton(tr("&Later"), QMessageBox::RejectRole);
    question_->setEscapeButton(later);
    connect(question_, &QMessageBox::buttonClicked, this, [this, found](QAbstractButton* button) {
        QMessageBox* const asked = std::exchange(question_, nullptr);
        answer(found, asked->buttonRole(button));
    });
    question_->open();
}

void RestoreController::answer(const Found& found, QMessageBox::ButtonRole role) {
    const RecordingFolder folder = recordings_.folder();
    if (role == QMessageBox::AcceptRole) return restore(found);  // what else there is, the next start offers
    if (role == QMessageBox::DestructiveRole) folder.discard(found.leftover.file());
    if (role == QMessageBox::ActionRole) {
        const auto kept = folder.keep(found.leftover.file(), found.leftover.time(), found.facts.title);
        if (!kept) {
            messages_.showError(kept.error());
        } else {
            messages_.setHint(tr("The file is %1").arg(QString::fromStdString(kept->string())));
        }
    }
    askForNext();
}

void RestoreController::restore(const Found& found) {
    found_.clear();
    restoring_ = std::make_shared<Restoring>(found.leftover, QString::fromStdString(found.facts.title),
                                             std::make_shared<RestoreProgress>());
    teeth_.load(
        [restoring = restoring_, known = teeth_.knownFiles()]() -> Expected<SessionTooth> {
            Expected<SessionTooth> tooth = restoreSession(restoring->leftover, *restoring->progress);
            if (!tooth) return tooth;
            resumeWork(*tooth, {}, known);
            restoring->isDone = true;
            return tooth;
        },
        tr("Restoring the session…"), ToothController::LoadedShare(restoring_->progress, &restoring_->progress->part));
}

void RestoreController::takeTooth() {
    if (restoring_ == nullptr || !restoring_->isDone) return;
    const auto restored = std::exchange(restoring_, nullptr);
    const RecordingFolder folder = recordings_.folder();
    const std::filesystem::path& file = restored->leftover.file();
    // The new recording holds the saved tooth now. A recording is kept: it shows how the tooth was cut.
    if (restored->leftover.kind() == Leftover::Kind::Tooth && model_.isRecording()) return folder.discard(file);
    const auto kept = folder.keep(file, restored->leftover.time(), restored->title.toStdString());
    if (!kept) messages_.showError(kept.error());
}

}  // namespace tactooth
