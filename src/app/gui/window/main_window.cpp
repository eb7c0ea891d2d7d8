// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/window/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QScreen>
#include <QWindow>
#include <utility>

#include "app/gui/dialogs/settings_dialog.h"
#include "app/gui/model/current_work.h"
#include "app/gui/model/exercise_tooth.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/drive_panel.h"
#include "app/gui/panels/event_panel.h"
#include "app/gui/panels/exercise_panel.h"
#include "app/gui/panels/force_panel.h"
#include "app/gui/panels/plot_panel.h"
#include "app/gui/panels/sound_panel.h"
#include "app/gui/panels/status_line.h"
#include "app/gui/scene/event_banner.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/text/translation.h"
#include "app/gui/window/screen_fit.h"
#include "app/gui/window/settings_choices.h"

namespace tactooth {

MainWindow::MainWindow(SoundOutput& sound)
    : model_(sound),
      examination_(model_),
      frame_(model_, *this),
      work_(model_, examination_, frame_, *this),
      input_(model_, frame_, *this),
      help_(model_, frame_, input_, *this),
      output_(sound, model_, frame_),
      menus_(*this, frame_.docks, frame_.panels, model_, work_.teeth, work_.exercise, work_.recordings,
             work_.examinations, frame_.messages, input_.keys, help_.manual),
      history_(model_, examination_, frame_.panels, menus_.instruments()),
      loop_(model_),
      tools_({*this, sound, model_, examination_, frame_, work_, output_}),
      settings_(frame_, work_, input_, output_, menus_, tools_) {
    setWindowTitle(tr("Tactooth"));
    setAcceptDrops(true);
    frame_.messages.setHint(tr("Preparing the tooth…"));
    work_.teeth.setWork(
        [this] { return currentWork(model_, work_.exercise.active(), work_.exercise.targetFile().toStdString()); });
    work_.teeth.setShowsRecording([this] { return tools_.replay.isActive(); });
    connectDrill();
    connectView();
    connectLoop();
    connectNumbers();
    connect(&input_.devices, &DeviceController::userActive, &loop_, &StepLoop::wake);
    connect(&menus_.file(), &FileMenu::settingsWanted, this, &MainWindow::editSettings);
    connect(&menus_.file(), &FileMenu::keysWanted, &input_.keys, &KeyController::edit);
    connect(&tools_.replay, &ReplayController::pictureMade, &input_.keys, &KeyController::apply);
    connect(&input_.keys, &KeyController::changed, &help_.hints, &WindowHints::showUsual);
    connect(&menus_.file(), &FileMenu::recordingWanted, &tools_.replay, &ReplayController::askForRecording);
    connect(&work_.teeth, &ToothController::recordingChosen, &tools_.replay, &ReplayController::open);
    connect(&work_.teeth, &ToothController::twoRecordingsChosen, &tools_.replay, &ReplayController::openTwo);
    menus_.addReplayEntry(tools_.replay.comparison().sideBySideAction());
    connect(&menus_.exercise(), &ExerciseMenu::newExerciseWanted, &tools_.editor, &EditorController::beginNew);
    connect(&menus_.exercise(), &ExerciseMenu::copyWanted, &tools_.editor, &EditorController::askForCopy);
    connect(&tools_.editor, &EditorController::idealChanged, this, &MainWindow::updateInspection);
    connect(&tools_.editor, &EditorController::panelMade, &frame_.docks, &DockLayout::fitLater);
    connect(&menus_.appearance(), &AppearanceMenu::languageChosen, this, &MainWindow::languageChosen);
    connect(&menus_.appearance(), &AppearanceMenu::textScaleChanged, &frame_.docks, &DockLayout::fit);
    connect(&menus_.appearance(), &AppearanceMenu::coloursChanged, frame_.panels.plots, &PlotPanel::setColours);
    connect(&menus_, &WindowMenus::layoutResetWanted, this, [this] {
        frame_.docks.reset();
        work_.examinations.followLayout();
        fitToScreenLater();
    });
}

MainWindow::~MainWindow() = default;

void MainWindow::connectDrill() {
    connect(frame_.panels.drill, &DrillBar::burChosen, &work_.teeth, &ToothController::loadBur);
    connect(frame_.panels.drill, &DrillBar::burFileChosen, &work_.teeth, &ToothController::openBur);
    connect(frame_.panels.drill, &DrillBar::spindleChosen, this, [this](const SpindlePreset& spindle) {
        model_.setSpindle(spindle);
        frame_.panels.drive->setSpindle(spindle);
    });
    connect(frame_.panels.drill, &DrillBar::cuttingChanged, this, [this](bool cutting) {
        model_.setCutting(cutting);
        help_.hints.showUsual();
    });
    connect(frame_.panels.drill->resetAction(), &QAction::triggered, this, [this] { model_.resetTooth(); });
    connect(frame_.panels.force, &ForcePanel::changed, this, [this] {
        model_.controls.force = frame_.panels.force->overrides();
        model_.controls.forceScale = frame_.panels.force->forceScale();
    });
    connect(frame_.panels.force, &ForcePanel::handChanged, this, [this] { frame_.panels.force->applyTo(model_); });
    frame_.panels.force->applyTo(model_);
}

void MainWindow::connectView() {
    connect(frame_.panels.view, &ToothView::pressDepthChanged, frame_.panels.force, &ForcePanel::setPressDepth);
    connect(frame_.panels.view, &ToothView::depthChanged, frame_.panels.force, &ForcePanel::setDepth);
    connect(frame_.panels.view, &ToothView::failed, this, &MainWindow::graphicsFailed, Qt::QueuedConnection);
    connect(frame_.panels.inspection, &InspectionPanel::changed, this, &MainWindow::updateInspection);
    connect(frame_.panels.events, &EventPanel::notified, this, [this](const QString& sentence) {
        if (examination_.showsNumbers()) frame_.messages.setHint(sentence);
    });
    auto* banner = new EventBanner(frame_.panels.view);
    connect(frame_.panels.events, &EventPanel::added, banner, [this, banner](const CutEvent& event) {
        constexpr double kNew = 3;  // s: older ones come with a tooth that somebody has worked on before
        if (!examination_.showsNumbers() || event.time < model_.log().newest().time - kNew) return;
        if (banner->announce(event.kind) && !frame_.panels.sound->mixer().muted) QApplication::beep();
    });
    connect(frame_.panels.events, &EventPanel::placeChosen, frame_.panels.view, &ToothView::centreOn);
}

void MainWindow::connectLoop() {
    connect(&loop_, &StepLoop::aboutToStep, this, [this](double dt) {
        input_.devices.step(dt);
        frame_.writer.poll();
        work_.restorer.poll();
        work_.teeth.poll();
    });
    connect(&loop_, &StepLoop::recordingFailed, &work_.recordings, &RecordingController::showFault);
    connect(&loop_, &StepLoop::recordingResumed, &work_.recordings, &RecordingController::showResumed);
    connect(&loop_, &StepLoop::faultChanged, &help_.hints, &WindowHints::showFault);
    connect(&loop_, &StepLoop::overloaded, &help_.hints, &WindowHints::showOverload);
    connect(&loop_, &StepLoop::runnerStarted, &output_.updater, &PanelUpdater::restart);
    connect(&loop_, &StepLoop::runnerStarted, &history_, &HistoryActions::takeRunner);
    connect(&loop_, &StepLoop::runnerStarted, &input_.instruments, &InstrumentController::takeRunner);
    connect(&work_.exercise, &ExerciseController::activeChanged, this,
            [this] { input_.instruments.follow(work_.exercise.active()); });
    connect(&input_.instruments, &InstrumentController::changed, &help_.hints, &WindowHints::showUsual);
    connect(&loop_, &StepLoop::toothChanged, this, &MainWindow::showNewTooth);
    connect(&loop_, &StepLoop::stepped, this, [this] {
        model_.noteMirror(frame_.panels.view->mirrorSight());
        input_.devices.followButtons();
        output_.sounds.poll();
        input_.instruments.poll();
        work_.exercise.poll();
        tools_.editor.poll();
        tools_.finish.poll();
        const bool hasBar = frame_.panels.status->showWork(longWork());
        output_.updater.showStep(!hasBar && (isBusy() || work_.teeth.isImporting() || tools_.replay.isLoading()));
        loop_.setBusy(isBusy() || work_.restorer.isBusy() || tools_.finish.isAssessing() || work_.exercise.isBusy() ||
                      isWriting());
        frame_.unsaved.update();
        closeWhenWritten();
    });
}

/// What somebody may wait for; of several works the one that changes the most.
std::optional<LongWork> MainWindow::longWork() {
    if (auto work = work_.teeth.loading()) return work;
    if (auto work = tools_.finish.assessing()) return work;
    if (auto work = work_.exercise.preparing()) return work;
    if (auto work = history_.undoing()) return work;
    return writing();
}

std::optional<LongWork> MainWindow::writing() {
    if (!isWriting()) return std::nullopt;
    return LongWork{.title = tr("Writing a file"),
                    .share = frame_.writer.share(),
                    .cancel = [this] { frame_.writer.cancel(); },
                    .cancelTip = tr("No file is written or changed")};
}

/// A file that could not be written, or that was given up, keeps the window open.
void MainWindow::closeWhenWritten() {
    if (!closesUnless_ || isWriting()) return;
    if (*std::exchange(closesUnless_, std::nullopt) == frame_.writer.unwritten()) {
        close();
    } else {
        mayClose_ = false;
    }
}

void MainWindow::connectNumbers() {
    connect(&loop_, &StepLoop::statusDue, &output_.updater, &PanelUpdater::showStatus);
    connect(&loop_, &StepLoop::statusDue, &work_.recordings, &RecordingController::update);
    connect(&loop_, &StepLoop::numbersDue, this, [this] {
        output_.updater.showNumbers();
        history_.update();
        // A clock behind another tab would make the desktop compose the whole window each second.
        if (isInSight(*frame_.panels.exercise)) work_.exercise.showProgress();
        input_.devices.showState();
        help_.hints.update();
        tools_.thumbnails.update();
    });
}

void MainWindow::showNewTooth() {
    setWindowTitle(tr("%1[*] — Tactooth").arg(translated(model_.tooth()->name)));
    menus_.file().showTooth();
    help_.hints.showUsual();
    showImportNotes();
    frame_.panels.view->resetView();
    frame_.panels.view->measureTool().takeTooth();
    work_.exercise.takeTooth();
    tools_.editor.takeTooth();
    work_.restorer.takeTooth();
    frame_.panels.force->setMaterials(model_.haptics().materials);
    if (!pendingViewState_) {
        work_.exercise.beginExercise();
        return work_.recordings.update();
    }
    ViewState state = *std::exchange(pendingViewState_, std::nullopt);
    frame_.panels.view->setOrbitCamera(state.camera);
    work_.exercise.restore(std::move(state.target));
    frame_.panels.inspection->choose(state.inside);
    work_.recordings.update();
}

void MainWindow::showImportNotes() {
    QStringList hints;
    for (const ImportNote& importNote : model_.tooth()->importNotes) hints.push_back(translated(importNote.message));
    const MaterialRegistry& materials = model_.haptics().materials.registry();
    const auto exercise = exerciseOf(*model_.tooth());
    const bool areOfProgram = exercise != nullptr && exercise->file.empty() && exercise->materials == &materials;
    if (&materials != &builtinMaterials() && !areOfProgram) {
        hints.push_back(tr("This tooth brings its own materials: it may feel harder, softer or rougher than others"));
    }
    if (!hints.isEmpty()) frame_.messages.setHint(hints.join(' '));
}

void MainWindow::updateInspection() {
    if (!model_.tooth()) return;
    const MaterialRegistry& materials = model_.haptics().materials.registry();
    Inspection inspection = frame_.panels.inspection->inspection(model_.tooth()->box(), model_.mesialX(), materials);
    if (tools_.editor.shownIdeal() != nullptr) {  // in place of a target that the user has opened
        inspection.ghost = tools_.editor.shownIdeal();
        inspection.distances.reset();
    }
    frame_.panels.view->setInspection(inspection, frame_.panels.inspection->stereo());
}

void MainWindow::apply(const WindowSettings& settings) {
    settings_.apply(settings);
    work_.exercise.addOwn();
}

WindowSettings MainWindow::settings() const { return settings_.current(); }

void MainWindow::change(const WindowSettings& wanted) {
    const std::string language = settings().language;
    settings_.change(wanted);
    if (wanted.language != language) emit languageChosen();
}

void MainWindow::editSettings() {
    auto* dialog = new SettingsDialog(settings(), settingsChoices(frame_.panels), this);
    connect(dialog, &SettingsDialog::changed, this, [this, dialog] { change(dialog->settings()); });
    connect(dialog, &SettingsDialog::keysWanted, &input_.keys, &KeyController::edit);
    dialog->open();
}

MainWindow::SessionState MainWindow::releaseSession() {
    frame_.writer.finish();  // what comes of it is said in this window
    SessionState work{
        model_.tooth(),
        model_.bur(),
        work_.teeth.source(),
        {frame_.panels.view->orbitCamera(), frame_.panels.inspection->choice(), work_.exercise.targetState()},
        {},
        model_.history().cutsAlone(),
        frame_.panels.drill->isCutting(),
        frame_.panels.drive->isKeptDown()};
    if (work.tooth) {
        setExercise(*work.tooth, work_.exercise.active());
        work.tooth->work = currentWork(model_, work_.exercise.active(), work_.exercise.targetFile().toStdString());
    }
    work.keeper = model_.releaseKeeper();
    work.draft = tools_.editor.release();
    return work;
}

void MainWindow::restoreSession(SessionState work) {
    work_.teeth.setSource(std::move(work.source));
    if (work.keeper != nullptr) model_.adopt(std::move(work.keeper));
    model_.adopt(std::move(work.history));
    if (work.tooth) {
        work.tooth->bur.reset();  // the user may have put another one into the handpiece
        model_.install(std::move(*work.tooth));
        pendingViewState_ = std::move(work.viewState);
        if (work.draft) tools_.editor.adopt(std::move(*work.draft));
    }
    if (work.bur) model_.install(std::move(*work.bur));
    if (work.cutting) frame_.panels.drill->cutAction()->setChecked(true);
    frame_.panels.drive->setKeptDown(work.pedalIsKept);
}

void MainWindow::saveBeforeEnd() {
    mayClose_ = true;
    frame_.messages.silence();
    frame_.writer.finish();
    work_.recordings.saveBeforeEnd();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (isWriting()) {
        closesUnless_ = frame_.writer.unwritten();
        frame_.messages.setHint(tr("A file is being written: the window closes as soon as it is complete"));
        return event->ignore();
    }
    if (mayClose_ || !frame_.unsaved.isUnsaved()) {
        help_.manual.close();
        return QMainWindow::closeEvent(event);
    }
    event->ignore();
    frame_.unsaved.confirmDiscard([this] {
        mayClose_ = true;
        close();
    });
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    std::vector<std::filesystem::path> files;
    for (const QUrl& url : event->mimeData()->urls()) {
        if (url.isLocalFile()) files.emplace_back(url.toLocalFile().toStdString());
    }
    if (files.empty()) return;
    event->acceptProposedAction();
    work_.teeth.openDropped(files);
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::FontChange) frame_.docks.fitLater();
    // When the window is active, the window manager has put its frame around it.
    if (event->type() == QEvent::ActivationChange && isActiveWindow() && std::exchange(awaitsFrame_, false)) {
        fitToScreenLater();
    }
}

/// As soon as the docks have got their sizes.
void MainWindow::fitToScreenLater() {
    QTimer::singleShot(0, this, [this] {
        if (!isVisible() || isMaximized() || isFullScreen() || windowHandle() == nullptr) return;
        const QRect fitted = fittedInto(screen()->availableGeometry(), geometry(), windowHandle()->frameMargins());
        if (fitted != geometry()) setGeometry(fitted);
    });
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    frame_.docks.fitLater();
    awaitsFrame_ = true;
    fitToScreenLater();
}

}  // namespace tactooth
