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
      panels_(model_, *this),
      messages_(*panels_.status, *this),
      files_(*this),
      docks_(*this, panels_),
      unsaved_(model_, *this),
      teeth_(model_, examination_, messages_, files_, unsaved_, *this),
      exercise_(model_, examination_, panels_, messages_, files_, teeth_),
      recordings_(model_, examination_, panels_, messages_, exercise_),
      examinations_(examination_, model_, panels_, docks_, exercise_, recordings_, messages_, *this),
      restorer_(model_, teeth_, recordings_, messages_, *this),
      devices_(*this, model_, panels_, messages_),
      instruments_(model_, panels_),
      keys_(*this, panels_, messages_),
      manual_(*this, keys_),
      hints_(model_, panels_, devices_, messages_),
      sounds_(sound, model_, panels_, messages_, files_),
      records_(model_, panels_, messages_, files_),
      menus_(*this, docks_, panels_, model_, teeth_, exercise_, recordings_, examinations_, messages_, keys_, manual_),
      history_(model_, examination_, panels_, menus_.instruments()),
      updater_(model_, panels_, sound),
      loop_(model_),
      replay_(*this, model_, examination_, panels_, messages_, files_, updater_, sound),
      finish_({*this, model_, examination_, examinations_, panels_, messages_, files_, exercise_, replay_}),
      editor_({*this, model_, examination_, panels_, messages_, files_, teeth_, exercise_, unsaved_}) {
    setWindowTitle(tr("Tactooth"));
    setAcceptDrops(true);
    messages_.setHint(tr("Preparing the tooth…"));
    teeth_.setWork([this] { return currentWork(model_, exercise_.active(), exercise_.targetFile().toStdString()); });
    teeth_.setShowsRecording([this] { return replay_.isActive(); });
    connectDrill();
    connectView();
    connectLoop();
    connectNumbers();
    connect(&devices_, &DeviceController::userActive, &loop_, &StepLoop::wake);
    connect(&menus_.file(), &FileMenu::settingsWanted, this, &MainWindow::editSettings);
    connect(&menus_.file(), &FileMenu::keysWanted, &keys_, &KeyController::edit);
    connect(&replay_, &ReplayController::pictureMade, &keys_, &KeyController::apply);
    connect(&keys_, &KeyController::changed, &hints_, &WindowHints::showUsual);
    connect(&menus_.file(), &FileMenu::recordingWanted, &replay_, &ReplayController::askForRecording);
    connect(&teeth_, &ToothController::recordingChosen, &replay_, &ReplayController::open);
    connect(&teeth_, &ToothController::twoRecordingsChosen, &replay_, &ReplayController::openTwo);
    menus_.addReplayEntry(replay_.comparison().sideBySideAction());
    connect(&menus_.exercise(), &ExerciseMenu::newExerciseWanted, &editor_, &EditorController::beginNew);
    connect(&menus_.exercise(), &ExerciseMenu::copyWanted, &editor_, &EditorController::askForCopy);
    connect(&editor_, &EditorController::panelMade, &docks_, &DockLayout::fitLater);
    connect(&menus_.appearance(), &AppearanceMenu::languageChosen, this, &MainWindow::languageChosen);
    connect(&menus_.appearance(), &AppearanceMenu::textScaleChanged, &docks_, &DockLayout::fit);
    connect(&menus_.appearance(), &AppearanceMenu::coloursChanged, panels_.plots, &PlotPanel::setColours);
    connect(&menus_, &WindowMenus::layoutResetWanted, this, [this] {
        docks_.reset();
        examinations_.followLayout();
        fitToScreenLater();
    });
}

MainWindow::~MainWindow() = default;

void MainWindow::connectDrill() {
    connect(panels_.drill, &DrillBar::burChosen, &teeth_, &ToothController::loadBur);
    connect(panels_.drill, &DrillBar::burFileChosen, &teeth_, &ToothController::openBur);
    connect(panels_.drill, &DrillBar::spindleChosen, this, [this](const SpindlePreset& spindle) {
        model_.setSpindle(spindle);
        panels_.drive->setSpindle(spindle);
    });
    connect(panels_.drill, &DrillBar::cuttingChanged, this, [this](bool cutting) {
        model_.setCutting(cutting);
        hints_.showUsual();
    });
    connect(panels_.drill->resetAction(), &QAction::triggered, this, [this] { model_.resetTooth(); });
    connect(panels_.force, &ForcePanel::changed, this, [this] {
        model_.controls.force = panels_.force->overrides();
        model_.controls.forceScale = panels_.force->forceScale();
    });
    connect(panels_.force, &ForcePanel::handChanged, this, [this] { panels_.force->applyTo(model_); });
    panels_.force->applyTo(model_);
}

void MainWindow::connectView() {
    connect(panels_.view, &ToothView::pressDepthChanged, panels_.force, &ForcePanel::setPressDepth);
    connect(panels_.view, &ToothView::depthChanged, panels_.force, &ForcePanel::setDepth);
    connect(panels_.view, &ToothView::failed, this, &MainWindow::graphicsFailed, Qt::QueuedConnection);
    connect(panels_.inspection, &InspectionPanel::changed, this, &MainWindow::updateInspection);
    connect(panels_.events, &EventPanel::notified, this, [this](const QString& sentence) {
        if (examination_.showsNumbers()) messages_.setHint(sentence);
    });
    auto* banner = new EventBanner(panels_.view);
    connect(panels_.events, &EventPanel::added, banner, [this, banner](const CutEvent& event) {
        constexpr double kNew = 3;  // s: older ones come with a tooth that somebody has worked on before
        if (!examination_.showsNumbers() || event.time < model_.log().newest().time - kNew) return;
        if (banner->announce(event.kind) && !panels_.sound->mixer().muted) QApplication::beep();
    });
    connect(panels_.events, &EventPanel::placeChosen, panels_.view, &ToothView::centreOn);
}

void MainWindow::connectLoop() {
    connect(&loop_, &StepLoop::aboutToStep, this, [this](double dt) {
        devices_.step(dt);
        restorer_.poll();
        teeth_.poll();
    });
    connect(&loop_, &StepLoop::recordingFailed, &recordings_, &RecordingController::showFault);
    connect(&loop_, &StepLoop::faultChanged, &hints_, &WindowHints::showFault);
    connect(&loop_, &StepLoop::overloaded, &hints_, &WindowHints::showOverload);
    connect(&loop_, &StepLoop::runnerStarted, &updater_, &PanelUpdater::restart);
    connect(&loop_, &StepLoop::runnerStarted, &history_, &HistoryActions::takeRunner);
    connect(&loop_, &StepLoop::runnerStarted, &instruments_, &InstrumentController::takeRunner);
    connect(&instruments_, &InstrumentController::changed, &hints_, &WindowHints::showUsual);
    connect(&loop_, &StepLoop::toothChanged, this, &MainWindow::showNewTooth);
    connect(&loop_, &StepLoop::stepped, this, [this] {
        devices_.followButtons();
        sounds_.poll();
        instruments_.poll();
        exercise_.poll();
        finish_.poll();
        const bool isLoading = teeth_.isBusy() || !finish_.isAssessing();
        const bool hasBar =
            isLoading ? panels_.status->showLoading(teeth_.isBusy(), teeth_.loadedShare(), model_.tooth().has_value())
                      : panels_.status->showAssessing(finish_.assessedShare());
        updater_.showStep(!hasBar && (isBusy() || teeth_.isImporting() || replay_.isLoading()));
        loop_.setBusy(isBusy() || restorer_.isBusy() || finish_.isAssessing());
        unsaved_.showState();
    });
}

void MainWindow::connectNumbers() {
    connect(panels_.status, &StatusLine::loadingCancelled, this,
            [this] { teeth_.isBusy() || !finish_.isAssessing() ? teeth_.cancelLoading() : finish_.cancel(); });
    connect(&loop_, &StepLoop::statusDue, &updater_, &PanelUpdater::showStatus);
    connect(&loop_, &StepLoop::statusDue, &recordings_, &RecordingController::update);
    connect(&loop_, &StepLoop::numbersDue, this, [this] {
        updater_.showNumbers();
        history_.update();
        // A clock behind another tab would make the desktop compose the whole window each second.
        if (isInSight(*panels_.exercise)) exercise_.showProgress();
        devices_.showState();
        hints_.update();
    });
}

void MainWindow::showNewTooth() {
    setWindowTitle(tr("%1[*] — Tactooth").arg(translated(model_.tooth()->name)));
    menus_.file().showTooth();
    hints_.showUsual();
    showImportNotes();
    panels_.view->resetView();
    panels_.view->measureTool().takeTooth();
    exercise_.takeTooth();
    editor_.takeTooth();
    restorer_.takeTooth();
    panels_.force->setMaterials(model_.haptics().materials);
    if (!pendingViewState_) {
        exercise_.beginExercise();
        return recordings_.update();
    }
    ViewState state = *std::exchange(pendingViewState_, std::nullopt);
    panels_.view->setOrbitCamera(state.camera);
    exercise_.restore(std::move(state.target));
    panels_.inspection->choose(state.inside);
    recordings_.update();
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
    if (!hints.isEmpty()) messages_.setHint(hints.join(' '));
}

void MainWindow::updateInspection() {
    if (!model_.tooth()) return;
    const MaterialRegistry& materials = model_.haptics().materials.registry();
    panels_.view->setInspection(panels_.inspection->inspection(model_.tooth()->box(), model_.mesialX(), materials),
                                panels_.inspection->stereo());
}

void MainWindow::apply(const WindowSettings& settings) {
    docks_.restore(settings);
    files_.setFolder(QString::fromStdString(settings.folder));
    panels_.drill->choose(QString::fromStdString(settings.bur), QString::fromStdString(settings.spindle));
    menus_.restore(settings);
    panels_.force->set(settings.force);
    keys_.restore(settings);
    DeviceSettings hand = settings.hand;
    hand.pedalKey = keys_.pedalKey();
    devices_.apply(hand);
    sounds_.restore(settings);
    recordings_.restore(settings);
    replay_.comparison().restore(settings);
    exercise_.addOwn();
}

WindowSettings MainWindow::settings() const {
    WindowSettings settings;
    docks_.store(settings);
    examinations_.store(settings);
    settings.folder = files_.folder().toStdString();
    settings.bur = panels_.drill->burNumber().toStdString();
    settings.spindle = panels_.drill->spindleName().toStdString();
    menus_.store(settings);
    settings.force = panels_.force->settings();
    settings.hand = devices_.settings();
    keys_.store(settings);
    sounds_.store(settings);
    recordings_.store(settings);
    replay_.comparison().store(settings);
    return settings;
}

void MainWindow::change(const WindowSettings& wanted) {
    const WindowSettings now = settings();
    files_.setFolder(QString::fromStdString(wanted.folder));
    const auto changed = [](const std::string& before, const std::string& after) {
        return before == after ? QString() : QString::fromStdString(after);
    };
    panels_.drill->choose(changed(now.bur, wanted.bur), changed(now.spindle, wanted.spindle));
    menus_.restore(wanted);
    replay_.comparison().restore(wanted);
    if (wanted.force != now.force) panels_.force->set(wanted.force);
    devices_.change(wanted.hand);
    sounds_.change(wanted);
    const bool recordsOtherwise =
        wanted.recordsSessions != now.recordsSessions || wanted.recordingGigabytes != now.recordingGigabytes;
    if (recordsOtherwise) recordings_.restore(wanted);
    if (wanted.language != now.language) emit languageChosen();
}

void MainWindow::editSettings() {
    auto* dialog = new SettingsDialog(settings(), settingsChoices(panels_), this);
    connect(dialog, &SettingsDialog::changed, this, [this, dialog] { change(dialog->settings()); });
    connect(dialog, &SettingsDialog::keysWanted, &keys_, &KeyController::edit);
    dialog->open();
}

MainWindow::SessionState MainWindow::releaseSession() {
    SessionState work{model_.tooth(),
                      model_.bur(),
                      teeth_.source(),
                      {panels_.view->orbitCamera(), panels_.inspection->choice(), exercise_.targetState()},
                      {},
                      model_.history().cutsAlone(),
                      panels_.drill->isCutting(),
                      panels_.drive->isKeptDown()};
    if (work.tooth) {
        setExercise(*work.tooth, exercise_.active());
        work.tooth->work = currentWork(model_, exercise_.active(), exercise_.targetFile().toStdString());
    }
    work.keeper = model_.releaseKeeper();
    work.draft = editor_.release();
    return work;
}

void MainWindow::restoreSession(SessionState work) {
    teeth_.setSource(std::move(work.source));
    if (work.keeper != nullptr) model_.adopt(std::move(work.keeper));
    model_.adopt(std::move(work.history));
    if (work.tooth) {
        work.tooth->bur.reset();  // the user may have put another one into the handpiece
        model_.install(std::move(*work.tooth));
        pendingViewState_ = std::move(work.viewState);
        if (work.draft) editor_.adopt(std::move(*work.draft));
    }
    if (work.bur) model_.install(std::move(*work.bur));
    if (work.cutting) panels_.drill->cutAction()->setChecked(true);
    panels_.drive->setKeptDown(work.pedalIsKept);
}

void MainWindow::saveBeforeEnd() {
    mayClose_ = true;
    recordings_.saveBeforeEnd();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (mayClose_ || !unsaved_.isUnsaved()) {
        manual_.close();
        return QMainWindow::closeEvent(event);
    }
    event->ignore();
    unsaved_.confirmDiscard([this] {
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
    teeth_.openDropped(files);
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::FontChange) docks_.fitLater();
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
    docks_.fitLater();
    awaitsFrame_ = true;
    fitToScreenLater();
}

}  // namespace tactooth
