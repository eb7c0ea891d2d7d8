// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/sound_controller.h"

#include "app/gui/controllers/file_dialogs.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/panels/sound_panel.h"
#include "app/gui/scene/tooth_view.h"
#include "session/audio/sound_preset.h"
#include "session/audio/sound_sources.h"
#include "session/io/material_file.h"

namespace tactooth {

SoundController::SoundController(SoundOutput& sound, SessionModel& model, const WindowPanels& panels,
                                 WindowMessages& messages, FileDialogs& files)
    : sound_(sound), model_(model), panels_(panels), messages_(messages), files_(files) {
    connect(panels_.sound, &SoundPanel::changed, this, [this] { sound_.setMixer(panels_.sound->mixer()); });
    connect(panels_.sound, &SoundPanel::headphonesChanged, this, [this](bool on) { sound_.setHeadphones(on); });
    connect(panels_.sound, &SoundPanel::roomChanged, this, [this](bool on) { sound_.setRoom(on); });
    connect(panels_.sound, &SoundPanel::ownSoundsRequested, this, &SoundController::askForSounds);
    connect(panels_.sound, &SoundPanel::synthesisChosen, this, &SoundController::useSynthesis);
}

void SoundController::askForSounds() {
    files_.open(tr("Own sounds: a recording of the free-running drive, or a preset"),
                tr("Recordings and presets (*.wav *.flac *.ogg *.toml);;All files (*)"), [this](const QString& file) {
                    files_.enterFolderOf(file);
                    open(file);
                });
}

void SoundController::useSynthesis() {
    pending_.cancel();  // a recording that is still being read
    file_.clear();
    sound_.setKit(nullptr);
}

void SoundController::open(const QString& file) {
    read(file, &withDentalMaterials(model_.haptics().materials.registry()));
}

void SoundController::read(const QString& file, const MaterialRegistry* materials) {
    pending_.start([file = file.toStdString(), drive = model_.haptics().spindle, materials]() -> Expected<OwnSounds> {
        auto kit = readSoundKit(file, drive, materials);
        if (!kit) return Unexpected{kit.error()};
        return OwnSounds{file, std::move(*kit)};
    });
}

/// After a failure the sounds before go on.
void SoundController::collect() {
    auto sounds = pending_.poll();
    if (!sounds) return;
    if (!*sounds) return messages_.showError(sounds->error());
    file_ = QString::fromStdString((*sounds)->file);
    panels_.sound->showSounds(file_);
    sound_.setKit((*sounds)->kit);
}

void SoundController::place() {
    if (model_.runner() == nullptr) return;
    sound_.setPlacement(soundPlacementAt(model_.tooth()->box(), model_.mesialX(),
                                         model_.log().newest().contact.proxy.position,
                                         panels_.view->camera().cameraInWorld));
}

void SoundController::poll() {
    collect();
    place();
}

/// The sounds were chosen for teeth of before, and no tooth is there yet: they may name any material.
void SoundController::restore(const WindowSettings& settings) {
    panels_.sound->setMixer(settings.sound);
    panels_.sound->setHeadphones(settings.headphones);
    panels_.sound->setRoom(settings.room);
    if (!settings.ownSounds.empty()) read(QString::fromStdString(settings.ownSounds), nullptr);
}

void SoundController::change(const WindowSettings& settings) {
    panels_.sound->setMixer(settings.sound);
    panels_.sound->setHeadphones(settings.headphones);
    panels_.sound->setRoom(settings.room);
    const QString file = QString::fromStdString(settings.ownSounds);
    if (file == file_) return;
    if (!file.isEmpty()) return open(file);
    useSynthesis();
    panels_.sound->showSounds({});
}

void SoundController::store(WindowSettings& settings) const {
    settings.sound = panels_.sound->mixer();
    settings.headphones = panels_.sound->headphones();
    settings.room = panels_.sound->room();
    settings.ownSounds = file_.toStdString();
}

}  // namespace tactooth
