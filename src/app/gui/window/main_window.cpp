// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/window/main_window.h"

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QScrollArea>
#include <QStyle>
#include <algorithm>
#include <array>
#include <utility>

#include "app/gui/dialogs/guided_tour.h"
#include "app/gui/dialogs/open_tooth_dialog.h"
#include "app/gui/dialogs/scan_importer.h"
#include "app/gui/panels/device_panel.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/drive_panel.h"
#include "app/gui/panels/event_panel.h"
#include "app/gui/panels/exercise_panel.h"
#include "app/gui/panels/force_panel.h"
#include "app/gui/panels/inspection_panel.h"
#include "app/gui/panels/plot_panel.h"
#include "app/gui/panels/sound_panel.h"
#include "app/gui/panels/status_line.h"
#include "app/gui/panels/timing_panel.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/text/translation.h"
#include "geometry/io/stl_writer.h"

namespace tactooth {
namespace {

constexpr int kStepMs = 16;         // the hand moves 60 times a second ...
constexpr double kStandsStill = 1;  // rev/min: a spindle that runs down gets slower without end
constexpr int kRestMs = 40;         // ... and rests at fewer,
constexpr int kRestAfter = 120;     // steps in which nobody has moved anything
constexpr double kSeenMove = 1e-4;  // mm
constexpr int kNumbersMs = 100;     // gauges and plots: ten times a second
constexpr int kStatusMs = 1000;
constexpr int kStatusAtRestMs = 5000;  // each new text has the whole window composed anew
constexpr int kLayout = 3;  // counts the arrangements of docks: one that was saved with others of them is not taken
constexpr double kLongestStep = 0.1;  // s: after a stall the hand goes on gently

/// With large text on a small screen everything can still be reached. `sideways`: also what is too wide; else the area
/// takes the width that the panel needs.
QScrollArea* scrolling(QWidget& panel, bool sideways) {
    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);  // its controls are stops of the Tab key, it is none
    area->setHorizontalScrollBarPolicy(sideways ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);
    area->setWidget(&panel);
    return area;
}

/// Whether any of it shows; what stands behind another tab counts as visible for Qt.
bool isInSight(const QWidget& panel) { return !panel.visibleRegion().isEmpty(); }

}  // namespace

MainWindow::MainWindow(SoundOutput& sound)
    : sound_(sound),
      model_(sound),
      view_(new ToothView(model_)),
      drill_(new DrillBar),
      drive_(new DrivePanel),
      force_(new ForcePanel),
      inspectionPanel_(new InspectionPanel),
      devicePanel_(new DevicePanel),
      tour_(new GuidedTour(model_, *view_, *drill_, *drive_, this)),
      soundPanel_(new SoundPanel),
      plots_(new PlotPanel),
      eventPanel_(new EventPanel),
      exercise_(new ExercisePanel),
      timing_(new TimingPanel),
      importer_(new ScanImporter(this)),
      status_(new StatusLine),
      busy_(new QProgressBar),
      fileBar_(addToolBar(tr("File"))),
      viewBar_(new QToolBar(tr("View"))),
      gamepad_(*this, *view_) {
    setWindowTitle(tr("Tactooth"));
    setAcceptDrops(true);
    setCentralWidget(view_);
    setStatusBar(status_);
    addPanels();
    addFileMenu();
    addViewMenu();
    addDrillAndSoundMenus();
    addHelpMenu();
    connectPanels();
    qApp->installEventFilter(this);  // the pedal key works wherever the focus is
    connect(&stepTimer_, &QTimer::timeout, this, &MainWindow::step);
    connect(&numbersTimer_, &QTimer::timeout, this, &MainWindow::showNumbers);
    connect(&statusTimer_, &QTimer::timeout, this, [this] {
        if (model_.simulator() != nullptr) showStatus(*model_.simulator());
    });
    stepTimer_.start(kStepMs);
    numbersTimer_.start(kNumbersMs);
    statusTimer_.start(kStatusMs);
    resize(1400, 900);
}

MainWindow::~MainWindow() = default;

QDockWidget* MainWindow::addDock(QWidget& panel, const QString& title, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title);
    dock->setObjectName(title);
    const bool scrolls = &panel != plots_ && &panel != eventPanel_;  // these two take any size
    dock->setWidget(scrolls ? scrolling(panel, area != Qt::RightDockWidgetArea) : &panel);
    addDockWidget(area, dock);
    return dock;
}

void MainWindow::addPanels() {
    fileBar_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    fileBar_->setObjectName("fileBar");
    drill_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    viewBar_->setObjectName("viewBar");
    addToolBar(viewBar_);
    addToolBarBreak();
    addToolBar(drill_);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    QDockWidget* drill = addDock(*drive_, tr("Drill"), Qt::RightDockWidgetArea);
    QDockWidget* force = addDock(*force_, tr("Force"), Qt::RightDockWidgetArea);
    QDockWidget* hand = addDock(*devicePanel_, tr("Hand"), Qt::RightDockWidgetArea);
    QDockWidget* sound = addDock(*soundPanel_, tr("Sound"), Qt::RightDockWidgetArea);
    tabifyDockWidget(force, hand);
    tabifyDockWidget(hand, sound);  // what one sets once; all of them one below the other are higher than most screens
    force->raise();
    QDockWidget* inside = addDock(*inspectionPanel_, tr("Look inside"), Qt::RightDockWidgetArea);
    QDockWidget* plots = addDock(*plots_, tr("Last ten seconds"), Qt::BottomDockWidgetArea);
    tabifyDockWidget(plots, addDock(*exercise_, tr("Exercise"), Qt::BottomDockWidgetArea));
    tabifyDockWidget(plots, addDock(*eventPanel_, tr("What happened"), Qt::BottomDockWidgetArea));
    tabifyDockWidget(plots, addDock(*timing_, tr("Real time"), Qt::BottomDockWidgetArea));
    plots->raise();
    fitPanels();
    // What stands behind the first tab may be scrolled; what is seen at once is seen whole.
    resizeDocks({drill, force, inside},
                {drive_->sizeHint().height(), force_->sizeHint().height(), inspectionPanel_->sizeHint().height()},
                Qt::Vertical);
    busy_->setRange(0, 0);
    busy_->setMaximumWidth(120);
    busy_->setObjectName("busy");
    status_->addPermanentWidget(busy_);
    status_->setHint(tr("Preparing the tooth…"));
}

/// All but the lowest need no more than their contents; that takes what is left.
int MainWindow::tabHeight() const {
    return std::max({force_->sizeHint().height(), devicePanel_->sizeHint().height(), soundPanel_->sizeHint().height()});
}

/// All but the lowest need no more than their contents; that takes what is left. The gauges are always seen whole.
void MainWindow::fitPanels() {
    for (auto* area : findChildren<QScrollArea*>()) {
        QWidget& panel = *area->widget();
        if (area->horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) continue;
        panel.ensurePolished();
        panel.layout()->invalidate();  // its size is that of the letters before
        area->setMinimumWidth(panel.minimumSizeHint().width() + style()->pixelMetric(QStyle::PM_ScrollBarExtent));
        if (&panel == inspectionPanel_) continue;
        area->setMaximumHeight(&panel == drive_ ? panel.sizeHint().height() : tabHeight());
        if (&panel == drive_) area->setMinimumHeight(panel.sizeHint().height());
    }
    QFont title = QApplication::font();
    title.setStyleStrategy(QFont::PreferAntialias);  // a dock with the usual font has a title that stays small
    for (auto* dock : findChildren<QDockWidget*>()) dock->setFont(title);
}

/// Other letters have come, which the panels take over one by one.
void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::FontChange) QTimer::singleShot(0, this, &MainWindow::fitPanels);
}

/// Before that the panels do not know their letters.
void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    QTimer::singleShot(0, this, &MainWindow::fitPanels);
}

void MainWindow::addFileMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&File"));
    QAction* open = menu->addAction(style()->standardIcon(QStyle::SP_DialogOpenButton), tr("&Open tooth…"), this,
                                    &MainWindow::askForTooth);
    open->setShortcut(QKeySequence::Open);
    QMenu* builtin = menu->addMenu(tr("&Built-in teeth"));
    for (const BuiltinToothEntry& entry : kBuiltinTeeth) {
        builtin->addAction(translated(entry.name), this, [this, &entry] { loadBuiltinTooth(entry); });
    }
    addMouthMenu(*menu);
    recentMenu_ = menu->addMenu(tr("Open &recent"));
    recentMenu_->setObjectName("recent");
    connect(recentMenu_, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
    caseMenu_ = menu->addMenu(tr("Tooth of the &case"));
    caseMenu_->setObjectName("teethOfCase");
    connect(caseMenu_, &QMenu::aboutToShow, this, &MainWindow::fillCaseMenu);
    menu->addAction(tr("&Import scan…"), this, &MainWindow::askForScan)->setShortcut(QKeySequence("Ctrl+I"));
    menu->addAction(tr("Open &bur…"), this, &MainWindow::askForBur);
    menu->addAction(tr("Open e&xercise…"), this, &MainWindow::askForExercise);
    menu->addAction(tr("&Save tooth…"), this, &MainWindow::askForSave)->setShortcut(QKeySequence::Save);
    QAction* save = menu->addAction(style()->standardIcon(QStyle::SP_DialogSaveButton), tr("&Export cut tooth…"), this,
                                    &MainWindow::askForExport);
    save->setShortcut(QKeySequence::SaveAs);
    menu->addSeparator();
    menu->addAction(tr("&Quit"), this, &QWidget::close)->setShortcut(QKeySequence("Ctrl+Q"));
    fileBar_->addAction(open);
    fileBar_->addAction(builtin->menuAction());
    fileBar_->addAction(save);
}

/// Each tooth by its number, the quadrants as on a dentist's chart.
void MainWindow::addMouthMenu(QMenu& menu) {
    QMenu* mouth = menu.addMenu(tr("&Whole mouth"));
    mouth->setObjectName("mouth");
    const std::array quadrants = {tr("Upper right"), tr("Upper left"), tr("Lower left"), tr("Lower right")};
    for (int quadrant = 1; quadrant <= 4; ++quadrant) {
        QMenu* side = mouth->addMenu(quadrants[static_cast<std::size_t>(quadrant - 1)]);
        for (int fdi = 10 * quadrant + 1; isPermanentTooth(fdi); ++fdi) {
            side->addAction(QString::number(fdi), this, [this, fdi] { loadMouth({.fdi = fdi}); });
        }
    }
}

void MainWindow::addDrillAndSoundMenus() {
    QMenu* menu = menuBar()->addMenu(tr("&Drill"));
    menu->addActions({drill_->touchAction(), drill_->cutAction(), devicePanel_->clutchAction()});
    menu->addSeparator();
    menu->addAction(tr("Stand the bur &upright"), this, [this] { model_.manipulator().resetOrientation(); })
        ->setShortcut(QKeySequence("U"));
    constexpr double kTurn = 0.2;  // rad for one press of the key
    menu->addAction(tr("Turn the handle &left"), this, [this] { model_.manipulator().rotateHandle(kTurn); })
        ->setShortcut(QKeySequence("Q"));
    menu->addAction(tr("Turn the handle &right"), this, [this] { model_.manipulator().rotateHandle(-kTurn); })
        ->setShortcut(QKeySequence("E"));
    menu->addSeparator();
    addSpraySwitches(*menu);
    menu->addSeparator();
    menu->addActions({drill_->undoAction(), drill_->resetAction()});

    QAction* mute = menuBar()->addMenu(tr("&Sound"))->addAction(tr("&Mute"));
    mute->setCheckable(true);
    mute->setShortcut(QKeySequence("Ctrl+M"));
    connect(mute, &QAction::toggled, soundPanel_, &SoundPanel::setMuted);
    connect(soundPanel_, &SoundPanel::mutedChanged, mute, &QAction::setChecked);
}

void MainWindow::addHelpMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Help"));
    menu->addAction(tr("&Welcome"), this, &MainWindow::welcome);
    menu->addAction(tr("Watch the &demonstration"), this, &MainWindow::showDemonstration);
    menu->addAction(tr("&Mouse and keys"), this, &MainWindow::showMouseAndKeys)->setShortcut(QKeySequence("F1"));
    menu->addAction(tr("&About Tactooth"), this, &MainWindow::showAbout);
}

void MainWindow::connectPanels() {
    connect(drill_, &DrillBar::burChosen, this, &MainWindow::loadBur);
    connect(drill_, &DrillBar::burFileChosen, this, &MainWindow::openBur);
    connect(drill_, &DrillBar::spindleChosen, this, [this](const SpindlePreset& spindle) {
        model_.setSpindle(spindle);
        drive_->setSpindle(spindle);
    });
    connect(drill_, &DrillBar::cuttingChanged, this, [this](bool cutting) {
        model_.setCutting(cutting);
        showUsualHint();
    });
    connect(drill_->resetAction(), &QAction::triggered, this, [this] { model_.resetTooth(); });
    connect(drill_->undoAction(), &QAction::triggered, this, [this] {
        if (model_.simulator() != nullptr) model_.simulator()->requestUndo();
    });
    connect(drive_, &DrivePanel::pedalChanged, this, [this](double pedal) {
        if (pedal > 0 && !drill_->isCutting()) {
            status_->setHint(tr("In Touch the bur stands still: choose Cut (C), and the pedal turns it"));
        }
    });
    connect(force_, &ForcePanel::changed, this, [this] {
        model_.controls.force = force_->overrides();
        model_.controls.forceScale = force_->forceScale();
    });
    connect(force_, &ForcePanel::pressDepthChanged, this,
            [this](double mm) { model_.manipulator().setPressDepth(mm); });
    connect(view_, &ToothView::pressDepthChanged, force_, &ForcePanel::setPressDepth);
    connect(view_, &ToothView::failed, this, &MainWindow::graphicsFailed, Qt::QueuedConnection);
    connect(importer_, &ScanImporter::failed, this, qOverload<const QString&>(&MainWindow::showError));
    connect(importer_, &ScanImporter::imported, this, [this](const SessionTooth& tooth) {
        status_->setHint(tr("%1 was imported").arg(QString::fromStdString(tooth.name)));
        model_.install(tooth);
    });
    connectSound();
    connectInspection();
    connectRecords();
    connectExercise();
    connectDevice();
}

void MainWindow::connectRecords() {
    connect(plots_, &PlotPanel::exportRequested, this, &MainWindow::askForPlotFile);
    connect(eventPanel_, &EventPanel::exportRequested, this, &MainWindow::askForEventFile);
    connect(eventPanel_, &EventPanel::notified, status_, &StatusLine::setHint);
    connect(eventPanel_, &EventPanel::placeChosen, view_, &ToothView::centreOn);
}

/// A window that nobody uses leaves the computer to others.
void MainWindow::adaptStepInterval() {
    const Vec3& place = model_.newest().proxy.position;
    const bool isStill =
        (place - lastPlace_).norm() < kSeenMove && model_.newest().speedRpm < kStandsStill && !model_.isBusy();
    lastPlace_ = place;
    idleSteps_ = isStill ? idleSteps_ + 1 : 0;
    const bool rests = idleSteps_ > kRestAfter;
    const auto pace = [](QTimer& timer, int pause) {
        if (timer.interval() != pause) timer.setInterval(pause);
    };
    pace(stepTimer_, rests ? kRestMs : kStepMs);
    pace(statusTimer_, rests ? kStatusAtRestMs : kStatusMs);
}

void MainWindow::step() {
    const double dt = sinceStep_.isValid() ? static_cast<double>(sinceStep_.restart()) / 1000 : (sinceStep_.start(), 0);
    stepPedal();
    collectDevices();
    stepGamepad(std::min(dt, kLongestStep));
    applyStepResult(model_.step(std::min(dt, kLongestStep)));
    followButtons();
    collectSounds();
    collectTarget();
    updateMetrics();
    importer_->poll();
    placeSounds();
    trace_.add(model_.ticks());
    busy_->setVisible(model_.isBusy() || importer_->isBusy());
    view_->refresh();
    adaptStepInterval();
}

void MainWindow::showUsualHint() {
    if (model_.device() == nullptr) {
        status_->setHint(
            tr("Left button: press the bur on the tooth · wheel: harder, softer · right: turn · space: pedal"));
    } else if (gamepad_.isInPanels()) {
        status_->setHint(tr("D-pad: control and value · shoulders: panel · A: press · B: back to the tooth"));
    } else if (usesGamepad()) {
        status_->setHint(
            tr("Left stick: move · left trigger: press · left shoulder: lift · right stick: lean · right trigger: "
               "pedal · A: touch or cut · d-pad: turn · Start: menus · Back: panels"));
    } else {
        status_->setHint(tr("Move the device: the bur follows it · space: pedal · C: cut, T: touch"));
    }
}

void MainWindow::applyStepResult(const SessionModel::StepResult& stepResult) {
    if (stepResult.failure) {
        showError(*stepResult.failure);
        exercise_->show(activeExercise_);  // the tooth of another one may not have come
    }
    // No message that would take the keys and the pedal from a hand at work.
    if (stepResult.faultMessage) {
        *stepResult.faultMessage != nullptr ? status_->setHint(translated(**stepResult.faultMessage)) : showUsualHint();
        deviceHint_ = DeviceHint::None;
    }
    if (stepResult.heavyTick) {
        status_->setHint(
            tr("The scene is heavy for this machine: one tick in a hundred takes %1 of the %2 µs that there are; "
               "take a tooth of fewer triangles ('tactooth simplify') or a bur of fewer triangles, and close "
               "other programs.")
                .arg(*stepResult.heavyTick, 0, 'f', 0)
                .arg(1e6 / model_.rate(), 0, 'f', 0));
    }
    if (stepResult.newSimulator) {
        trace_.clear();
        timing_->reset();
        drill_->show(QString::fromStdString(model_.bur()->name), QString::fromStdString(model_.bur()->file.string()));
    }
    if (!stepResult.newTooth) return;
    setWindowTitle(tr("%1 — Tactooth").arg(translated(model_.tooth()->name)));
    showUsualHint();
    QStringList hints;
    for (const ImportNote& importNote : model_.tooth()->importNotes) hints.push_back(translated(importNote.message));
    if (model_.tooth()->materials) {
        hints.push_back(tr("This case brings its own materials: it may feel harder, softer or rougher than others"));
    }
    if (!hints.isEmpty()) status_->setHint(hints.join(' '));
    view_->resetView();
    view_->fit();
    clearTarget();  // it is in the frame of the tooth before
    activeExercise_ = model_.tooth()->exercise;
    exercise_->show(activeExercise_);
    if (pendingViewState_) return restoreViewState(*std::exchange(pendingViewState_, std::nullopt));
    if (activeExercise_ == nullptr) return;
    showCavityOf(*activeExercise_);
    loadIdealShapeOf(activeExercise_);
}

void MainWindow::apply(const WindowSettings& settings) {
    const auto unpacked = [](const std::string& text) {
        return QByteArray::fromBase64(QByteArray::fromStdString(text));
    };
    restoreGeometry(unpacked(settings.geometry));
    restoreState(unpacked(settings.docks), kLayout);
    folder_ = QString::fromStdString(settings.folder);
    drill_->choose(QString::fromStdString(settings.bur), QString::fromStdString(settings.spindle));
    mirrorSwitch_->setChecked(settings.showsMirror);
    turbineSwitch_->setChecked(settings.showsTurbine);
    darkSwitch_->setChecked(settings.dark);
    setLanguage(QString::fromStdString(settings.language));
    setTextScale(settings.textScale);
    recent_ = QString::fromStdString(settings.recent).split('\n', Qt::SkipEmptyParts);
    force_->set(settings.force);
    applyDeviceSettings(settings.hand);
    setMirror(settings.mirror);
    setSecondView(QString::fromStdString(settings.secondView));
    waterSwitch_->setChecked(settings.water);
    suctionSwitch_->setChecked(settings.suction);
    soundPanel_->setMixer(settings.sound);
    soundPanel_->setHeadphones(settings.headphones);
    if (!settings.ownSounds.empty()) openSounds(QString::fromStdString(settings.ownSounds));
}

WindowSettings MainWindow::settings() const {
    return {.geometry = saveGeometry().toBase64().toStdString(),
            .docks = saveState(kLayout).toBase64().toStdString(),
            .folder = folder_.toStdString(),
            .bur = drill_->burNumber().toStdString(),
            .spindle = drill_->spindleName().toStdString(),
            .showsTurbine = turbineSwitch_->isChecked(),
            .showsMirror = mirrorSwitch_->isChecked(),
            .force = force_->settings(),
            .hand = deviceSettings(),
            .sound = soundPanel_->mixer(),
            .headphones = soundPanel_->headphones(),
            .ownSounds = soundsFile_.toStdString(),
            .language = language_.toStdString(),
            .dark = darkSwitch_->isChecked(),
            .recent = recent_.join('\n').toStdString(),
            .mirror = mirror(),
            .water = waterSwitch_->isChecked(),
            .suction = suctionSwitch_->isChecked(),
            .textScale = textScale_,
            .secondView = secondViews_->checkedAction()->data().toString().toStdString()};
}

void MainWindow::showStatus(const Simulator& simulator) {
    status_->show(simulator, sound_.status());
    if (!isInSight(*timing_)) return;
    const HapticDevice* device = model_.device();
    timing_->show(simulator, device != nullptr ? QString::fromStdString(device->info().name) : tr("mouse"),
                  model_.rate());
}

void MainWindow::showNumbers() {
    drive_->show(model_.newest());
    plots_->show(trace_);
    eventPanel_->show(model_.events().all());
    // A clock behind another tab would have the whole window composed anew each second.
    if (model_.simulator() != nullptr && isInSight(*exercise_)) {
        exercise_->show(model_.workSeconds(), model_.simulator()->removed(), progress_);
    }
    showDeviceState();
}

}  // namespace tactooth
