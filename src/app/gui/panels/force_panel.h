// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QWidget>
#include <optional>

#include "app/gui/panels/number_row.h"
#include "app/gui/settings/window_settings.h"
#include "session/live/live_runner.h"

namespace tactooth {

class SessionModel;

/// The force parameters: spring, damper and friction (the materials' own, those of one tissue everywhere, or the user's
/// numbers), the scale of the force, the press depth of the mouse, and the depth at which mouse and device stop.
class ForcePanel final : public QWidget {
    Q_OBJECT

public:
    explicit ForcePanel(QWidget* parent = nullptr);

    [[nodiscard]] ForceOverrides overrides() const;
    [[nodiscard]] double forceScale() const { return scale_->value(); }
    [[nodiscard]] ForceSettings settings() const;
    void set(const ForceSettings& settings);
    /// Offers these materials: those of the tooth.
    void setMaterials(const MaterialTable& materials);
    void setPressDepth(double depth) { press_->setValue(depth); }
    void setDepth(double depth) { depth_->setValue(depth); }
    void setFlatFloor(bool isFlat) { flat_->setChecked(isFlat); }
    /// An exercise wants a device to stop at the depth. Without the wish it does what the user had set.
    void wantDepthStop(bool wanted);
    /// How the mouse presses, and whether a device stops at a depth.
    void applyTo(SessionModel& model) const;

signals:
    void changed();
    void handChanged();  ///< see applyTo

private:
    void addPresets(QGridLayout& grid);
    void addHand(QGridLayout& grid);
    void applyPreset(MaterialId tissue);

    MaterialTable materials_;
    QCheckBox* fromMaterial_;
    QComboBox* presets_;
    NumberRow* spring_;
    NumberRow* damper_;
    NumberRow* friction_;
    NumberRow* scale_;
    NumberRow* press_;
    QComboBox* mouse_;  // its data: ForceSettings::mouse
    NumberRow* depth_;
    QCheckBox* flat_;
    QCheckBox* stop_;
    std::optional<bool> chosenStop_;  // by the user, while an exercise has switched the stop on
    QCheckBox* guide_;
};

}  // namespace tactooth
