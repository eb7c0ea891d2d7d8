// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QMainWindow>
#include <QProgressBar>
#include <QTimer>
#include <filesystem>
#include <vector>

#include "app/gui/input/foot_pedal.h"
#include "app/gui/model/session_model.h"
#include "app/gui/model/target.h"
#include "app/gui/model/task.h"
#include "app/gui/panels/inspection_panel.h"
#include "app/gui/panels/tick_trace.h"
#include "app/gui/scene/gamepad_navigation.h"
#include "app/gui/settings/window_settings.h"
#include "sound/output/sound_output.h"

class QActionGroup;
class QDockWidget;

namespace tactooth {

class DrillBar;
class DrivePanel;
class EventPanel;
class ExercisePanel;
class ForcePanel;
class GuidedTour;
class DevicePanel;
class PlotPanel;
class ScanImporter;
class SoundPanel;
class StatusLine;
class TimingPanel;
class ToothView;

/// The simulator's window: wires the workbench to the widgets around it.
class MainWindow final : public QMainWindow {
    Q_OBJECT

public:
    /// `sound` outlives the window. Starts empty: bring or open something next.
    explicit MainWindow(SoundOutput& sound);
    ~MainWindow() override;

    [[nodiscard]] SessionModel& model() { return model_; }
    void loadBuiltinTooth(const BuiltinToothEntry& entry);
    /// A tooth among its neighbours and gums.
    void loadMouth(const MouthChoice& mouth);
    void openTooth(const ToothSource& source, const std::string& workOn = {});
    /// Surfaces of one tooth in whatever unit and position: shows what was assumed before it takes them.
    void importScan(const std::vector<std::filesystem::path>& files);
    void loadBur(const BurSpec& spec);
    void openBur(const QString& file);
    /// The window as it was the last time. Call before it is shown.
    void apply(const WindowSettings& settings);
    [[nodiscard]] WindowSettings settings() const;
    /// A message that does not stop the simulation.
    void showError(const QString& sentence);
    void showError(const Error& error);
    /// Plays the user's own sounds (see readSoundKit) as soon as they are read.
    void openSounds(const QString& file);
    /// Writes the tooth as it is now; says so if that fails.
    void exportTooth(const QString& file);
    /// Saves the tooth with its layers and all that was cut, to go on later; says so if that fails.
    void saveTooth(const QString& file);
    /// Three ways to begin, for who starts the program for the first time.
    void welcome();
    /// Compares the tooth with the closed surface in `file`: colours it by its distance to it, and has its ghost ready.
    void openTarget(const QString& file);
    /// Writes what the plots show; says so if that fails.
    void exportPlotsTo(const QString& file);
    /// Writes the list of what has happened; says so if that fails.
    void exportEventsTo(const QString& file);
    /// Brings the tooth, bur and target of an exercise; null: free practice, on the tooth as it is.
    void startExercise(const std::shared_ptr<const Exercise>& exercise);
    /// The same for one that a file describes; says so if that fails.
    void openExercise(const QString& file);
    /// Writes how far the student has come; says so if that fails.
    void exportReportTo(const QString& file);
    /// Opens a device (see openDevice), which then moves the bur; "mouse" for none. Says so if that fails, and the
    /// mouse goes on.
    void openFirstDevice(const QString& name);
    /// The same for the other hand, which begins with the mirror; "none" leaves it empty.
    void openSecondDevice(const QString& name);

    /// How the work is looked at, and what it is compared with.
    struct ViewState {
        OrbitCamera eye;
        InspectionPanel::Choice inside;
        Target target;       ///< empty: none, or it has not come yet
        QString targetFile;  ///< of one's own
    };
    /// What is worked on, and what the menus know of it.
    struct SessionState {
        std::optional<SessionTooth> tooth;
        std::optional<SessionBur> bur;
        ToothSource source;  ///< of the tooth
        ViewState viewState;
    };
    /// Ends the simulation: the work goes on in another window.
    [[nodiscard]] SessionState releaseSession();
    void restoreSession(SessionState work);

signals:
    /// Another language than that of this window, which settings() tells.
    void languageChosen();
    /// The graphics system cannot draw; a sentence. The window is of no use then.
    void graphicsFailed(const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void addPanels();
    void addFileMenu();
    void addMouthMenu(QMenu& menu);
    void addViewMenu();
    void addSecondViewMenu(const QStringList& titles);
    void setSecondView(const QString& name);
    void addAppearanceMenu();
    void addLanguageMenu();
    void setLanguage(const QString& code);
    void addDrillAndSoundMenus();
    void addHelpMenu();
    void addSpraySwitches(QMenu& menu);
    void addMirrorMenu();
    void replaceMirrorFromMenu();
    void setMirror(const MirrorSettings& mirror);
    [[nodiscard]] MirrorSettings mirror() const;
    QDockWidget* addDock(QWidget& panel, const QString& title, Qt::DockWidgetArea area);
    void connectPanels();
    void connectSound();
    void connectInspection();
    void connectRecords();
    void connectExercise();
    void connectDevice();
    void readDeviceSettings();
    void applyDeviceSettings(const DeviceSettings& settings);
    [[nodiscard]] DeviceSettings deviceSettings() const;
    void collectDevices();
    void stepPedal();
    [[nodiscard]] bool usesGamepad() const;
    void stepGamepad(double dt);
    void followButtons();
    void showDeviceState();
    void showDeviceHint();
    void updateInspection();
    void askForExercise();
    void openFile(const QString& file);
    void showCavityOf(const Exercise& exercise);
    void loadIdealShapeOf(const std::shared_ptr<const Exercise>& exercise);
    void restoreViewState(ViewState viewState);
    void setTarget(Target target);
    void clearTarget();
    void collectTarget();
    void updateMetrics();
    void setDark(bool dark);
    void addTextSizeMenu();
    void setTextScale(double scale);
    [[nodiscard]] int tabHeight() const;  ///< of the highest of those behind one another
    void fitPanels();
    void showDemonstration();
    void remember(const QString& file);
    void fillRecentMenu();
    QAction* addViewAction(const QString& text, const QString& keys, void (ToothView::*act)());

    void step();
    void adaptStepInterval();
    void showNumbers();
    void showStatus(const Simulator& simulator);
    void showUsualHint();
    void applyStepResult(const SessionModel::StepResult& stepResult);
    void collectSounds();
    void placeSounds();
    void askForTooth();
    void askForScan();
    void fillCaseMenu();
    void askForBur();
    void askWhereToWrite(const QString& title, const QString& filter, const QString& name,
                         void (MainWindow::*write)(const QString& file));
    void askForExport();
    void askForSounds();
    void askForSave();
    void askForTarget();
    void askForPlotFile();
    void askForEventFile();
    void askForReportFile();
    void showMouseAndKeys();
    void showAbout();

    struct OwnSounds {
        std::string file;
        std::shared_ptr<const SoundKit> kit;
    };

    SoundOutput& sound_;
    SessionModel model_;
    TickTrace trace_;
    ToothView* view_;
    DrillBar* drill_;
    DrivePanel* drive_;
    ForcePanel* force_;
    InspectionPanel* inspectionPanel_;
    DevicePanel* devicePanel_;
    GuidedTour* tour_;
    SoundPanel* soundPanel_;
    PlotPanel* plots_;
    EventPanel* eventPanel_;
    ExercisePanel* exercise_;
    TimingPanel* timing_;
    ScanImporter* importer_;
    StatusLine* status_;
    QProgressBar* busy_;
    QToolBar* fileBar_;
    QToolBar* viewBar_;
    QMenu* viewMenu_ = nullptr;
    QMenu* recentMenu_ = nullptr;
    QMenu* caseMenu_ = nullptr;
    ToothSource source_;  // of the tooth that was opened last
    QAction* darkSwitch_ = nullptr;
    QStringList recent_;  // newest first
    QActionGroup* languages_ = nullptr;
    QActionGroup* textSizes_ = nullptr;
    QActionGroup* secondViews_ = nullptr;
    double textScale_ = 1;
    QString language_;  // chosen; empty: the system's
    QAction* mirrorSwitch_ = nullptr;
    QAction* turbineSwitch_ = nullptr;
    QAction* waterSwitch_ = nullptr;
    QAction* suctionSwitch_ = nullptr;
    QActionGroup* mirrorSizes_ = nullptr;
    QAction* fogSwitch_ = nullptr;
    QAction* dropsSwitch_ = nullptr;
    QString folder_;      // of the last file
    QString soundsFile_;  // that is played; empty: the synthesised sounds
    Task<OwnSounds> pendingSounds_;
    Task<Target> pendingTarget_;
    Target target_;                                   // on the bench; empty: none
    QString targetFile_;                              // of one's own, once it is wanted
    std::shared_ptr<const Exercise> activeExercise_;  // none: free practice
    std::optional<ViewState> pendingViewState_;       // for the tooth that another window has handed over
    Task<CavityProgress> pendingProgress_;
    std::optional<CavityProgress> progress_;          // the newest
    std::shared_ptr<const Surface> measuredSurface_;  // the tooth that it is of
    QElapsedTimer sinceMetrics_;
    Task<std::unique_ptr<HapticDevice>> pendingDevice_, pendingSecondDevice_;
    std::string device_ = "mouse", second_ = "none";  // to be remembered, also where today it could not be opened
    FootPedal pedal_;
    GamepadNavigation gamepad_;
    Qt::Key pedalKey_ = Qt::Key_Space;
    double disagreesSince_ = 0;  // tick's time, s: bar and device about touch or cut
    /// Why the hand's work does not do what it is meant to.
    enum class DeviceHint { None, ForceWaits, WorkspaceEnd, BurStopped, OnlyTouches };
    [[nodiscard]] DeviceHint deviceHint();
    [[nodiscard]] QString deviceHintText(DeviceHint hint) const;
    DeviceHint deviceHint_ = DeviceHint::None;  // that the status line shows
    QTimer stepTimer_, numbersTimer_, statusTimer_;
    QElapsedTimer sinceStep_;
    Vec3 lastPlace_ = Vec3::Zero();
    int idleSteps_ = 0;  // since something moved
};

}  // namespace tactooth
