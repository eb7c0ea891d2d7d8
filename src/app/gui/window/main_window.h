// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <optional>

#include "app/gui/controllers/device_controller.h"
#include "app/gui/controllers/dock_layout.h"
#include "app/gui/controllers/examination_controller.h"
#include "app/gui/controllers/exercise_controller.h"
#include "app/gui/controllers/file_dialogs.h"
#include "app/gui/controllers/instrument_controller.h"
#include "app/gui/controllers/key_controller.h"
#include "app/gui/controllers/manual_controller.h"
#include "app/gui/controllers/panel_updater.h"
#include "app/gui/controllers/record_exports.h"
#include "app/gui/controllers/recording_controller.h"
#include "app/gui/controllers/restore_controller.h"
#include "app/gui/controllers/sound_controller.h"
#include "app/gui/controllers/step_loop.h"
#include "app/gui/controllers/tooth_controller.h"
#include "app/gui/controllers/unsaved_work.h"
#include "app/gui/controllers/window_hints.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/editor/editor_controller.h"
#include "app/gui/finish/finish_controller.h"
#include "app/gui/menus/history_actions.h"
#include "app/gui/menus/window_menus.h"
#include "app/gui/model/examination_mode.h"
#include "app/gui/panels/inspection_panel.h"
#include "app/gui/replay/replay_controller.h"

namespace tactooth {

/// The program's window: owns the session and the parts of the window, and connects them.
class MainWindow final : public QMainWindow {
    Q_OBJECT

public:
    /// `sound` outlives the window. The session begins without a tooth and without a bur.
    explicit MainWindow(SoundOutput& sound);
    ~MainWindow() override;

    [[nodiscard]] SessionModel& model() { return model_; }
    [[nodiscard]] ToothController& teeth() { return teeth_; }
    [[nodiscard]] ExerciseController& exercise() { return exercise_; }
    [[nodiscard]] DeviceController& devices() { return devices_; }
    [[nodiscard]] SoundController& sounds() { return sounds_; }
    [[nodiscard]] RecordExports& records() { return records_; }
    [[nodiscard]] RecordingController& recordings() { return recordings_; }
    [[nodiscard]] ExaminationMode& examination() { return examination_; }
    [[nodiscard]] RestoreController& restorer() { return restorer_; }
    [[nodiscard]] ReplayController& replay() { return replay_; }
    [[nodiscard]] FinishController& finish() { return finish_; }
    [[nodiscard]] EditorController& editor() { return editor_; }
    [[nodiscard]] WindowMessages& messages() { return messages_; }
    [[nodiscard]] ManualController& manual() { return manual_; }
    [[nodiscard]] const StepLoop& loop() const { return loop_; }
    /// A tooth, a bur or the instruments are being made.
    [[nodiscard]] bool isBusy() const {
        return teeth_.isBusy() || model_.instruments().isBusy() || model_.isPreparing();
    }
    /// Shows three ways to begin.
    void welcome() { menus_.welcome(); }

    /// The window as it was the last time. Call it before the window is shown.
    void apply(const WindowSettings& settings);
    [[nodiscard]] WindowSettings settings() const;
    /// Takes over what differs from settings(), but for layout and keys, while the work goes on.
    void change(const WindowSettings& wanted);

    /// How the user looks at the work, and the target it is compared with.
    struct ViewState {
        OrbitCamera camera;
        InspectionPanel::Choice inside;
        ExerciseController::TargetState target;
    };
    /// What a window hands over to another one.
    struct SessionState {
        std::optional<SessionTooth> tooth;
        std::optional<SessionBur> bur;
        ToothSource source;  ///< of the tooth
        ViewState viewState;
        std::unique_ptr<SessionKeeper> keeper;  ///< its recording goes on
        WorkHistory history;
        bool cutting = false;                     ///< touch or cut
        bool pedalIsKept = false;                 ///< "Keep down"
        std::optional<ExerciseDraft> draft = {};  ///< that is being edited
    };
    /// Ends the simulation: the work goes on in another window.
    [[nodiscard]] SessionState releaseSession();
    void restoreSession(SessionState work);

    /// The program ends, and nobody can answer a question: see RecordingController::saveBeforeEnd. Closing the window
    /// asks no more.
    void saveBeforeEnd();

signals:
    /// The user has chosen another language than that of this window; settings() has it.
    void languageChosen();
    /// The graphics system cannot draw; a sentence. The window is of no use then.
    void graphicsFailed(const QString& sentence);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    void connectDrill();
    void connectView();
    void connectLoop();
    void connectNumbers();
    void showNewTooth();
    void showImportNotes();
    void updateInspection();
    void fitToScreenLater();
    void editSettings();

    SessionModel model_;
    ExaminationMode examination_;
    WindowPanels panels_;
    WindowMessages messages_;
    FileDialogs files_;
    DockLayout docks_;
    UnsavedWork unsaved_;
    ToothController teeth_;
    ExerciseController exercise_;
    RecordingController recordings_;
    ExaminationController examinations_;
    RestoreController restorer_;
    DeviceController devices_;
    InstrumentController instruments_;
    KeyController keys_;
    ManualController manual_;
    WindowHints hints_;
    SoundController sounds_;
    RecordExports records_;
    WindowMenus menus_;
    HistoryActions history_;
    PanelUpdater updater_;
    StepLoop loop_;
    ReplayController replay_;
    FinishController finish_;
    EditorController editor_;
    std::optional<ViewState> pendingViewState_;  // of the tooth that another window has handed over
    bool mayClose_ = false;                      // nothing is lost, or the user agrees
    bool awaitsFrame_ = false;                   // shown, but the window manager may not have framed it yet
};

}  // namespace tactooth
