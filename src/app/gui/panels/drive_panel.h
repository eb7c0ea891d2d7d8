// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QSlider>
#include <QWidget>

#include "app/gui/panels/dial_gauge.h"
#include "haptics/haptic_simulation.h"

namespace tactooth {

/// The gauges of the drill (spindle speed and force on the bur) and the pedal.
class DrivePanel final : public QWidget {
    Q_OBJECT

public:
    explicit DrivePanel(QWidget* parent = nullptr);

    /// The pedal key is down or up.
    void setKeyDown(bool down);
    [[nodiscard]] double pedal() const;
    /// Whether the pedal stays down by itself.
    [[nodiscard]] bool isKeptDown() const { return keep_->isChecked(); }
    void setKeptDown(bool kept) { keep_->setChecked(kept); }
    void setSpindle(const SpindlePreset& spindle);
    void show(const Tick& tick);
    /// Whether there is a gauge of the force.
    void setShowsForce(bool shows);

signals:
    void pedalChanged(double pedal);

private:
    DialGauge* speed_;
    DialGauge* force_;
    QSlider* slider_;
    QCheckBox* keep_;
};

}  // namespace tactooth
