// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <string>

#include "app/gui/controllers/window_panels.h"
#include "app/gui/settings/window_settings.h"
#include "session/model/task.h"
#include "sound/output/sound_output.h"
#include "tooth/model/material_registry.h"

namespace tactooth {

class FileDialogs;
class WindowMessages;

/// Volumes, places of the sounds, and the user's own sounds.
class SoundController final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the controller.
    SoundController(SoundOutput& sound, SessionModel& model, const WindowPanels& panels, WindowMessages& messages,
                    FileDialogs& files);

    /// Plays the user's own sounds (see readSoundKit) once they are read; shows a message if that fails.
    void open(const QString& file);
    /// Takes over sounds that are ready and places the sound. Call it after each step of the model.
    void poll();
    /// A file of sounds is being read.
    [[nodiscard]] bool isReading() const { return pending_.isBusy(); }

    void restore(const WindowSettings& settings);
    /// The same, but sounds that stay are not read again.
    void change(const WindowSettings& settings);
    void store(WindowSettings& settings) const;

private:
    struct OwnSounds {
        std::string file;
        std::shared_ptr<const SoundKit> kit;
    };
    /// `materials`: as for readSoundKit.
    void read(const QString& file, const MaterialRegistry* materials);
    void askForSounds();
    void useSynthesis();
    void collect();
    void place();

    SoundOutput& sound_;
    SessionModel& model_;
    WindowPanels panels_;
    WindowMessages& messages_;
    FileDialogs& files_;
    Task<OwnSounds> pending_;
    QString file_;  // of the sounds that are played; empty: synthesised sounds
};

}  // namespace tactooth
