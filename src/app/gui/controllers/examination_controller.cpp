// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/examination_controller.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QPushButton>
#include <array>

#include "app/gui/controllers/dock_layout.h"
#include "app/gui/controllers/exercise_controller.h"
#include "app/gui/controllers/recording_controller.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/icons/line_icon.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/drive_panel.h"
#include "app/gui/panels/event_panel.h"
#include "app/gui/panels/exercise_panel.h"
#include "app/gui/panels/force_panel.h"
#include "app/gui/panels/history_panel.h"
#include "app/gui/panels/inspection_panel.h"
#include "app/gui/panels/plot_panel.h"
#include "app/gui/panels/status_line.h"
#include "app/gui/scene/tooth_view.h"
#include "session/model/session_model.h"
#include "session/recording/station_key.h"

namespace tactooth {
namespace {

QDockWidget* dockOf(QWidget* panel) {
    for (QWidget* widget = panel; widget != nullptr; widget = widget->parentWidget()) {
        if (auto* dock = qobject_cast<QDockWidget*>(widget)) return dock;
    }
    return nullptr;
}

}  // namespace

ExaminationController::ExaminationController(ExaminationMode& mode, SessionModel& model, const WindowPanels& panels,
                                             DockLayout& docks, ExerciseController& exercise,
                                             RecordingController& recordings, WindowMessages& messages, QWidget& window)
    : mode_(mode),
      model_(model),
      panels_(panels),
      docks_(docks),
      exercise_(exercise),
      recordings_(recordings),
      messages_(messages),
      window_(window),
      entry_(new QAction(tr("Begin exa&mination"), this)) {
    entry_->setObjectName("examination");
    setLineIcon(*entry_, "examination");
    connect(entry_, &QAction::triggered, this, [this] { mode_.isOn() ? askToFinish() : askToBegin(); });
    connect(&mode_, &ExaminationMode::changed, this, &ExaminationController::apply);
}

void ExaminationController::addTo(QMenu& menu) {
    entry_->setParent(&menu);
    menu.addAction(entry_);
}

void ExaminationController::store(WindowSettings& settings) const {
    if (mode_.isOn()) settings.docks = docksBefore_;
}

void ExaminationController::askToBegin() {
    if (!recordings_.hasFolder()) {
        return messages_.showError(
            tr("An examination is recorded, and this window keeps no recordings: start Tactooth "
               "without --no-record."));
    }
    if (model_.isTouched()) {
        return messages_.showError(
            tr("An examination begins with a tooth that nobody has touched: choose the exercise "
               "once more, or open the tooth again."));
    }
    Expected<StationKey> station = openStationKey();
    if (!station) return messages_.showError(station.error());
    mode_.begin(station->key);
}

void ExaminationController::askToFinish(const std::function<void()>& then) {
    if (question_ != nullptr) return;
    question_ = new QMessageBox(QMessageBox::Question, tr("Examination"), tr("Finish the examination?"),
                                QMessageBox::NoButton, &window_);
    question_->setObjectName("finishExamination");
    question_->setAttribute(Qt::WA_DeleteOnClose);
    question_->setInformativeText(tr("The recording is signed and closed; nothing can be added to it afterwards."));
    question_->addButton(tr("&Finish"), QMessageBox::AcceptRole);
    auto* goOn = question_->addButton(tr("&Go on"), QMessageBox::RejectRole);
    question_->setDefaultButton(goOn);
    question_->setEscapeButton(goOn);
    connect(question_, &QMessageBox::buttonClicked, this, [this, then](QAbstractButton* button) {
        if (question_->buttonRole(button) != QMessageBox::AcceptRole) return;
        mode_.finish();
        if (then) then();
    });
    question_->open();
}

void ExaminationController::showDocks(bool visible) const {
    const std::array<QWidget*, 5> panels = {panels_.force, panels_.inspection, panels_.plots, panels_.events,
                                            panels_.history};
    for (QWidget* panel : panels) {
        QDockWidget* const dock = dockOf(panel);
        if (dock == nullptr) continue;
        if (!visible) dock->hide();
        dock->toggleViewAction()->setEnabled(visible);
    }
}

void ExaminationController::followLayout() {
    if (!mode_.isOn()) return;
    WindowSettings now;
    docks_.store(now);
    docksBefore_ = now.docks;
    showDocks(mode_.showsNumbers());
}

void ExaminationController::apply() {
    entry_->setText(mode_.isOn() ? tr("Finish exa&mination…") : tr("Begin exa&mination"));
    WindowSettings now;
    docks_.store(now);
    if (mode_.isOn()) docksBefore_ = now.docks;
    showDocks(mode_.showsNumbers());
    panels_.drive->setShowsForce(mode_.showsNumbers());
    panels_.status->setShowsRemoved(mode_.showsNumbers());
    panels_.exercise->setShowsNumbers(mode_.showsNumbers());
    panels_.view->setShowsNumbers(mode_.showsNumbers());
    panels_.view->measureTool().setAllowed(mode_.allowsMeasuring());
    panels_.exercise->setAllowsRestart(mode_.allowsTakingBack());
    for (QAction* action : {panels_.drill->undoAction(), panels_.drill->redoAction(), panels_.drill->resetAction()}) {
        action->setEnabled(mode_.allowsTakingBack());
    }
    if (!mode_.showsTarget()) panels_.inspection->choose({});
    exercise_.showTarget();
    if (mode_.isOn()) {
        return messages_.setHint(tr("Examination: what you do is recorded and signed. There is no undo."));
    }
    now.docks = docksBefore_;
    docks_.restore(now);
    messages_.setHint(tr("The examination is over: its recording is signed and closed"));
}

}  // namespace tactooth
