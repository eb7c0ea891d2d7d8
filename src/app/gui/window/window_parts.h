// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
#include "app/gui/controllers/tooth_controller.h"
#include "app/gui/controllers/unsaved_work.h"
#include "app/gui/controllers/window_hints.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/controllers/window_panels.h"
#include "app/gui/editor/editor_controller.h"
#include "app/gui/finish/finish_controller.h"
#include "app/gui/replay/replay_controller.h"
#include "app/gui/window/thumbnail_controller.h"
#include "session/model/file_writer.h"

class QMainWindow;

// The parts of the window, grouped by what they are for. Each group takes what it uses from those before it; all that
// is given to a group outlives it.
namespace tactooth {

/// The widgets, their places, and what the program says and asks.
struct WindowFrame {
    WindowFrame(SessionModel& model, QMainWindow& window);

    WindowPanels panels;
    WindowMessages messages;
    FileDialogs files;
    DockLayout docks;
    FileWriter writer;  ///< of all that the user saves and exports
    UnsavedWork unsaved;
};

/// What the user works on: the tooth, the exercise, the recording and the examination.
struct WorkControllers {
    WorkControllers(SessionModel& model, ExaminationMode& mode, WindowFrame& frame, QMainWindow& window);

    ToothController teeth;
    ExerciseController exercise;
    RecordingController recordings;
    ExaminationController examinations;
    RestoreController restorer;
};

/// What the user works with.
struct InputControllers {
    InputControllers(SessionModel& model, WindowFrame& frame, QMainWindow& window);

    DeviceController devices;
    InstrumentController instruments;
    KeyController keys;
};

/// What explains the program.
struct HelpControllers {
    HelpControllers(SessionModel& model, WindowFrame& frame, InputControllers& input, QMainWindow& window);

    ManualController manual;
    WindowHints hints;
};

/// What the user hears, takes along as files, and reads in the panels.
struct OutputControllers {
    OutputControllers(SoundOutput& sound, SessionModel& model, WindowFrame& frame);

    SoundController sounds;
    RecordExports records;
    PanelUpdater updater;
};

/// What takes the place of the work or judges it: the replay, the report and the editor of exercises.
struct WorkTools {
    /// What the tools use.
    struct Parts {
        QMainWindow& window;
        SoundOutput& sound;
        SessionModel& model;
        ExaminationMode& mode;
        WindowFrame& frame;
        WorkControllers& work;
        OutputControllers& output;
    };
    explicit WorkTools(const Parts& parts);

    ReplayController replay;
    ThumbnailController thumbnails;
    FinishController finish;
    EditorController editor;
};

}  // namespace tactooth
