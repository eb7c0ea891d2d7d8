// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The window's ear: volumes, places and the user's own sounds.
#include <QFileDialog>
#include <QFileInfo>

#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/sound_panel.h"
#include "app/gui/panels/status_line.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/window/main_window.h"
#include "session/audio/sound_preset.h"
#include "session/audio/sound_sources.h"

namespace tactooth {

void MainWindow::connectSound() {
    connect(soundPanel_, &SoundPanel::changed, this, [this] { sound_.setMixer(soundPanel_->mixer()); });
    connect(soundPanel_, &SoundPanel::headphonesChanged, this, [this](bool on) { sound_.setHeadphones(on); });
    connect(soundPanel_, &SoundPanel::ownSoundsRequested, this, &MainWindow::askForSounds);
    connect(soundPanel_, &SoundPanel::synthesisChosen, this, [this] {
        pendingSounds_.cancel();  // a recording that is still being read must not win
        soundsFile_.clear();
        sound_.setKit(nullptr);
    });
}

void MainWindow::askForSounds() {
    auto* dialog = new QFileDialog(this, tr("Own sounds: a recording of the free-running drive, or a preset"), folder_,
                                   tr("Recordings and presets (*.wav *.flac *.ogg *.toml);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
        folder_ = QFileInfo(file).absolutePath();
        openSounds(file);
    });
    dialog->open();
}

void MainWindow::openSounds(const QString& file) {
    pendingSounds_.start([file = file.toStdString(), drive = model_.spindle()]() -> Expected<OwnSounds> {
        auto kit = readSoundKit(file, drive);
        if (!kit) return Unexpected{kit.error()};
        return OwnSounds{file, std::move(*kit)};
    });
}

/// A file that cannot be used leaves what was played before.
void MainWindow::collectSounds() {
    auto sounds = pendingSounds_.poll();
    if (!sounds) return;
    if (!*sounds) return showError(sounds->error());
    soundsFile_ = QString::fromStdString((*sounds)->file);
    soundPanel_->showSounds(soundsFile_);
    sound_.setKit((*sounds)->kit);
}

void MainWindow::placeSounds() {
    if (model_.simulator() == nullptr) return;
    sound_.setPlacement(soundPlacementAt(model_.tooth()->box(), model_.mesialX(), model_.newest().proxy.position,
                                         view_->camera().cameraInWorld));
}

}  // namespace tactooth
