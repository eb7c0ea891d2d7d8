// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <optional>

#include "app/gui/controllers/step_loop.h"
#include "app/gui/menus/history_actions.h"
#include "app/gui/menus/window_menus.h"
#include "app/gui/model/examination_mode.h"
#include "app/gui/panels/inspection_panel.h"
#include "app/gui/window/settings_binding.h"
#include "app/gui/window/window_parts.h"

namespace tactooth {

/// The program's window: owns the session and the parts of the window, and connects them. It closes after the files
/// that are being written.
class MainWindow final : public QMainWindow {
    Q_OBJECT

public:
    /// `sound` outlives the window. The session begins without a tooth and without a bur.
    explicit MainWindow(SoundOutput& sound);
    ~MainWindow() override;

    [[nodiscard]] SessionModel& model() { return model_; }
    [[nodiscard]] ToothController& teeth() { return work_.teeth; }
    [[nodiscard]] ExerciseController& exercise() { return work_.exercise; }
    [[nodiscard]] DeviceController& devices() { return input_.devices; }
    [[nodiscard]] SoundController& sounds() { return output_.sounds; }
    [[nodiscard]] RecordExports& records() { return output_.records; }
    [[nodiscard]] RecordingController& recordings() { return work_.recordings; }
    [[nodiscard]] ExaminationMode& examination() { return examination_; }
    [[nodiscard]] RestoreController& restorer() { return work_.restorer; }
    [[nodiscard]] ReplayController& replay() { return tools_.replay; }
    [[nodiscard]] FinishController& finish() { return tools_.finish; }
    [[nodiscard]] EditorController& editor() { return tools_.editor; }
    [[nodiscard]] WindowMessages& messages() { return frame_.messages; }
    [[nodiscard]] ManualController& manual() { return help_.manual; }
    [[nodiscard]] const StepLoop& loop() const { return loop_; }
    /// A tooth, a bur or the instruments are being made.
    [[nodiscard]] bool isBusy() const {
        return work_.teeth.isBusy() || model_.instruments().isBusy() || model_.isPreparing();
    }
    /// Writes all that the user saves and exports.
    [[nodiscard]] FileWriter& writer() { return frame_.writer; }
    [[nodiscard]] bool isWriting() const { return frame_.writer.isBusy(); }
    [[nodiscard]] WelcomeEntry& welcome() { return menus_.welcome(); }

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

    /// The program ends, and nobody can answer a question: waits for files that are being written, then see
    /// RecordingController::saveBeforeEnd. Closing the window asks no more.
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
    [[nodiscard]] std::optional<LongWork> longWork();
    [[nodiscard]] std::optional<LongWork> writing();
    void closeWhenWritten();
    void fitToScreenLater();
    void editSettings();

    SessionModel model_;
    ExaminationMode examination_;
    WindowFrame frame_;
    WorkControllers work_;
    InputControllers input_;
    HelpControllers help_;
    OutputControllers output_;
    WindowMenus menus_;
    HistoryActions history_;
    StepLoop loop_;
    WorkTools tools_;
    SettingsBinding settings_;
    std::optional<ViewState> pendingViewState_;  // of the tooth that another window has handed over
    bool mayClose_ = false;                      // nothing is lost, or the user agrees
    std::optional<std::size_t> closesUnless_;    // it closes after the files, unless more than these are unwritten
    bool awaitsFrame_ = false;                   // shown, but the window manager may not have framed it yet
};

}  // namespace tactooth
