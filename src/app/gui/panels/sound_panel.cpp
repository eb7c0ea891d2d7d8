// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/sound_panel.h"

#include <QFileInfo>
#include <QFormLayout>
#include <QSignalBlocker>
#include <cmath>

namespace tactooth {
namespace {

constexpr int kFull = 100;  // percent
constexpr int kSynthesised = 0;

QSlider* volumeSlider(const QString& tip) {
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setRange(0, kFull);
    slider->setValue(kFull);
    slider->setToolTip(tip);
    return slider;
}

double share(const QSlider* slider) { return static_cast<double>(slider->value()) / kFull; }

}  // namespace

SoundPanel::SoundPanel(QWidget* parent)
    : QWidget(parent),
      motor_(volumeSlider(tr("The turbine's own tone and its air"))),
      cutting_(volumeSlider(tr("The bur in the tooth"))),
      environment_(volumeSlider(tr("Spray and suction"))),
      master_(volumeSlider(tr("Everything"))),
      mute_(new QCheckBox(tr("Mute"))),
      headphones_(new QCheckBox(tr("Headphones"))),
      room_(new QCheckBox(tr("Room"))),
      sounds_(new QComboBox) {
    headphones_->setToolTip(
        tr("Places the sounds around the head, as two ears hear them; for loudspeakers leave it off"));
    room_->setToolTip(tr("Adds the sound of the surgery around the chair"));
    room_->setChecked(true);
    sounds_->setObjectName("sounds");
    auto* switches = new QHBoxLayout;
    switches->addWidget(mute_);
    switches->addWidget(headphones_);
    switches->addWidget(room_);
    switches->addStretch();
    auto* form = new QFormLayout(this);
    form->addRow(tr("Turbine"), motor_);
    form->addRow(tr("Cutting"), cutting_);
    form->addRow(tr("Water"), environment_);
    form->addRow(tr("All"), master_);
    form->addRow(QString(), switches);
    form->addRow(tr("Sounds"), sounds_);
    for (QSlider* slider : {motor_, cutting_, environment_, master_}) {
        connect(slider, &QSlider::valueChanged, this, &SoundPanel::changed);
    }
    connect(mute_, &QCheckBox::toggled, this, [this](bool muted) {
        emit changed();
        emit mutedChanged(muted);
    });
    connect(headphones_, &QCheckBox::toggled, this, &SoundPanel::headphonesChanged);
    connect(room_, &QCheckBox::toggled, this, &SoundPanel::roomChanged);
    connect(sounds_, &QComboBox::activated, this, &SoundPanel::chooseSounds);
    showSounds({});
}

SoundMixer SoundPanel::mixer() const {
    return {.motor = share(motor_),
            .cutting = share(cutting_),
            .master = share(master_),
            .muted = mute_->isChecked(),
            .environment = share(environment_)};
}

void SoundPanel::setMixer(const SoundMixer& mixer) {
    const auto show = [](QSlider* slider, double share) {
        slider->setValue(static_cast<int>(std::lround(kFull * share)));
    };
    show(motor_, mixer.motor);
    show(cutting_, mixer.cutting);
    show(environment_, mixer.environment);
    show(master_, mixer.master);
    mute_->setChecked(mixer.muted);
}

void SoundPanel::showSounds(const QString& file) {
    shownFile_ = file;
    const QSignalBlocker quiet(sounds_);
    sounds_->clear();
    sounds_->addItem(tr("Synthesised"));
    if (!file.isEmpty()) {
        sounds_->addItem(QFileInfo(file).fileName());
        sounds_->setItemData(1, file, Qt::ToolTipRole);
    }
    sounds_->addItem(tr("Own recordings…"));
    sounds_->setCurrentIndex(file.isEmpty() ? kSynthesised : 1);
}

/// The last entry asks for a file. The sounds in use go on until the file is read.
void SoundPanel::chooseSounds(int index) {
    if (index == sounds_->count() - 1) {
        showSounds(shownFile_);
        emit ownSoundsRequested();
    } else if (index == kSynthesised) {
        showSounds({});
        emit synthesisChosen();
    }
}

}  // namespace tactooth
