// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/drive_panel.h"

#include <QGridLayout>
#include <QLabel>

#include "haptics/safety_limiter.h"

namespace tactooth {
namespace {

constexpr int kPedalSteps = 100;
constexpr double kThousand = 1000;

}  // namespace

DrivePanel::DrivePanel(QWidget* parent)
    : QWidget(parent),
      speed_(new DialGauge({tr("Bur speed"), tr("× 1000 rev/min"), 400, 0})),
      force_(new DialGauge({tr("Force"), tr("N"), 4, 2, ForceLimits{}.force})),
      slider_(new QSlider(Qt::Horizontal)),
      keep_(new QCheckBox(tr("Keep down"))) {
    auto* grid = new QGridLayout(this);
    auto* gauges = new QHBoxLayout;
    gauges->addWidget(speed_);
    gauges->addWidget(force_);
    grid->addLayout(gauges, 0, 0, 1, 3);
    grid->addWidget(new QLabel(tr("Pedal")), 1, 0);
    grid->addWidget(slider_, 1, 1);
    grid->addWidget(keep_, 1, 2);
    grid->setRowStretch(2, 1);
    speed_->setObjectName("speedGauge");
    force_->setObjectName("forceGauge");
    slider_->setObjectName("pedal");
    slider_->setRange(0, kPedalSteps);
    slider_->setToolTip(tr("The foot pedal. Let go and it springs back; the space key presses it fully."));
    keep_->setToolTip(tr("The pedal stays where it is, so that the hand is free for the bur."));
    keep_->setObjectName("keepPedal");
    connect(slider_, &QSlider::valueChanged, this, [this] { emit pedalChanged(pedal()); });
    connect(slider_, &QSlider::sliderReleased, this, [this] {
        if (!keep_->isChecked()) slider_->setValue(0);
    });
    connect(keep_, &QCheckBox::toggled, this, [this](bool on) { slider_->setValue(on ? kPedalSteps : 0); });
}

void DrivePanel::setKeyDown(bool down) {
    if (!keep_->isChecked()) slider_->setValue(down ? kPedalSteps : 0);
}

double DrivePanel::pedal() const { return static_cast<double>(slider_->value()) / kPedalSteps; }

void DrivePanel::setSpindle(const SpindlePreset& spindle) { speed_->setLargest(spindle.freeSpeedRpm / kThousand); }

void DrivePanel::setShowsForce(bool shows) { force_->setVisible(shows); }

void DrivePanel::show(const Tick& tick) {
    speed_->setValue(tick.spindle.speedRpm / kThousand);
    force_->setValue(tick.force.wrench.force.norm());
}

}  // namespace tactooth
