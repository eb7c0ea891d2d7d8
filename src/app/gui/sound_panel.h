// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QSlider>
#include <QWidget>

#include "sound/sound_mixer.h"

namespace tactooth {

/// The three volumes and the mute switch.
class SoundPanel final : public QWidget {
    Q_OBJECT

public:
    explicit SoundPanel(QWidget* parent = nullptr);

    [[nodiscard]] SoundMixer mixer() const;
    void setMixer(const SoundMixer& mixer);
    void setMuted(bool muted) { mute_->setChecked(muted); }

signals:
    void changed();
    void mutedChanged(bool muted);

private:
    QSlider* motor_;
    QSlider* cutting_;
    QSlider* master_;
    QCheckBox* mute_;
};

}  // namespace tactooth
