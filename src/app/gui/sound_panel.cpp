// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/sound_panel.h"

#include <QFormLayout>
#include <cmath>

namespace tactooth {
namespace {

constexpr int kFull = 100;  // percent

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
      master_(volumeSlider(tr("Everything"))),
      mute_(new QCheckBox(tr("Mute"))) {
    auto* form = new QFormLayout(this);
    form->addRow(tr("Turbine"), motor_);
    form->addRow(tr("Cutting"), cutting_);
    form->addRow(tr("All"), master_);
    form->addRow(QString(), mute_);
    for (QSlider* slider : {motor_, cutting_, master_}) {
        connect(slider, &QSlider::valueChanged, this, &SoundPanel::changed);
    }
    connect(mute_, &QCheckBox::toggled, this, [this](bool muted) {
        emit changed();
        emit mutedChanged(muted);
    });
}

SoundMixer SoundPanel::mixer() const {
    return {.motor = share(motor_), .cutting = share(cutting_), .master = share(master_), .muted = mute_->isChecked()};
}

void SoundPanel::setMixer(const SoundMixer& mixer) {
    const auto show = [](QSlider* slider, double share) {
        slider->setValue(static_cast<int>(std::lround(kFull * share)));
    };
    show(motor_, mixer.motor);
    show(cutting_, mixer.cutting);
    show(master_, mixer.master);
    mute_->setChecked(mixer.muted);
}

}  // namespace tactooth
