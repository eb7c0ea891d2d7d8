// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QSlider>
#include <QWidget>

#include "sound/voices/sound_mixer.h"

namespace tactooth {

/// Volumes, mute switch, headphones, and the choice between synthesised and own sounds.
class SoundPanel final : public QWidget {
    Q_OBJECT

public:
    explicit SoundPanel(QWidget* parent = nullptr);

    [[nodiscard]] SoundMixer mixer() const;
    void setMixer(const SoundMixer& mixer);
    void setMuted(bool muted) { mute_->setChecked(muted); }
    [[nodiscard]] bool headphones() const { return headphones_->isChecked(); }
    void setHeadphones(bool headphones) { headphones_->setChecked(headphones); }
    [[nodiscard]] bool room() const { return room_->isChecked(); }
    void setRoom(bool room) { room_->setChecked(room); }
    /// Shows the file of the sounds in use; empty: synthesised sounds.
    void showSounds(const QString& file);

signals:
    void changed();
    void mutedChanged(bool muted);
    void headphonesChanged(bool headphones);
    void roomChanged(bool room);
    void synthesisChosen();
    /// The user wants to choose a file.
    void ownSoundsRequested();

private:
    void chooseSounds(int index);

    QSlider* motor_;
    QSlider* cutting_;
    QSlider* environment_;
    QSlider* master_;
    QCheckBox* mute_;
    QCheckBox* headphones_;
    QCheckBox* room_;
    QComboBox* sounds_;
    QString shownFile_;
};

}  // namespace tactooth
