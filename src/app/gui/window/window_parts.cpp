// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/window/window_parts.h"

#include <QMainWindow>

namespace tactooth {

WindowFrame::WindowFrame(SessionModel& model, QMainWindow& window)
    : panels(model, window),
      messages(*panels.status, window),
      files(window),
      docks(window, panels),
      unsaved(model, writer, window) {}

WorkControllers::WorkControllers(SessionModel& model, ExaminationMode& mode, WindowFrame& frame, QMainWindow& window)
    : teeth(model, mode, frame.messages, frame.files, frame.writer, frame.unsaved, window),
      exercise(model, mode, frame.panels, frame.messages, frame.files, frame.writer, teeth),
      recordings(model, mode, frame.panels, frame.messages, exercise),
      examinations(mode, model, frame.panels, frame.docks, exercise, recordings, frame.messages, window),
      restorer(model, teeth, recordings, frame.messages, window) {}

InputControllers::InputControllers(SessionModel& model, WindowFrame& frame, QMainWindow& window)
    : devices(window, model, frame.panels, frame.messages),
      instruments(model, frame.panels),
      keys(window, frame.panels, frame.messages) {}

HelpControllers::HelpControllers(SessionModel& model, WindowFrame& frame, InputControllers& input, QMainWindow& window)
    : manual(window, input.keys), hints(model, frame.panels, input.devices, frame.messages) {}

OutputControllers::OutputControllers(SoundOutput& sound, SessionModel& model, WindowFrame& frame)
    : sounds(sound, model, frame.panels, frame.messages, frame.files),
      records(model, frame.panels, frame.messages, frame.files, frame.writer),
      updater(model, frame.panels, sound) {}

WorkTools::WorkTools(const Parts& parts)
    : replay(parts.window, parts.model, parts.mode, parts.frame.panels, parts.frame.messages, parts.frame.files,
             parts.output.updater, parts.sound),
      thumbnails(parts.model, *parts.frame.panels.view, parts.work.teeth,
                 [this, &teeth = parts.work.teeth] {
                     using Shown = ThumbnailController::Shown;
                     if (teeth.isBusy() || replay.isLoading()) return Shown::Loading;
                     return replay.isActive() ? Shown::Recording : Shown::Session;
                 }),
      finish({parts.window, parts.model, parts.mode, parts.work.examinations, parts.frame.panels, parts.frame.messages,
              parts.frame.files, parts.frame.writer, parts.work.exercise, replay}),
      editor({parts.window, parts.model, parts.mode, parts.frame.panels, parts.frame.messages, parts.frame.files,
              parts.work.teeth, parts.work.exercise, parts.frame.unsaved}) {}

}  // namespace tactooth
