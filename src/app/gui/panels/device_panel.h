// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <array>
#include <optional>

#include "app/gui/panels/number_row.h"
#include "app/gui/settings/window_settings.h"
#include "devices/base/workspace_fit.h"
#include "devices/probe/device_backend.h"
#include "geometry/util/message.h"
#include "haptics/force_pipeline.h"
#include "session/control/button_actions.h"

namespace tactooth {

/// The devices of both hands, motion scaling, buttons, clutch and foot pedal.
class DevicePanel final : public QWidget {
    Q_OBJECT

public:
    explicit DevicePanel(QWidget* parent = nullptr);

    [[nodiscard]] DeviceSettings settings() const;
    void set(const DeviceSettings& settings);
    /// Shows a device by the name that openDevice takes; emits nothing.
    void showDevice(const QString& name) { showChosen(*devices_, name); }
    /// The same for the other hand; "none": it is empty.
    void showSecondDevice(const QString& name) { showChosen(*seconds_, name); }
    /// One key without modifiers.
    void setPedalKey(const QKeySequence& key);
    void showPedal(const std::string& pedal, double up, double down);
    void setCalibrating(bool calibrating) { calibrate_->setChecked(calibrating); }

    [[nodiscard]] ButtonMap buttons() const;
    [[nodiscard]] bool clutch() const { return clutch_->isChecked(); }
    /// The clutch for a menu. Its key works even if the panel is hidden or closed.
    [[nodiscard]] QAction* clutchAction() { return clutchAction_; }

    /// Shows the motion scaling that fits the tooth, if the user has chosen the fit; none: no device has a bounded
    /// workspace.
    void showFit(const std::optional<WorkspaceFit>& fit);
    /// Shows the state of the device; an empty name means the mouse.
    void showState(const QString& device, ForceState force, const Message* faultMessage);
    /// The same for the other hand; an empty name shows nothing.
    void showSecondState(const QString& device, const Message* faultMessage);

signals:
    void deviceChosen(const QString& name);
    void secondDeviceChosen(const QString& name);
    void changed();
    void calibratingChanged(bool calibrating);

private:
    static void showChosen(QComboBox& box, const QString& name);
    void showRate(double rate);
    void addDevices(QGridLayout& grid);
    void addUnits(const DeviceBackend& kind);
    void addHold(QGridLayout& grid);
    void addMotionScaling(QGridLayout& grid);
    void addRate(QGridLayout& grid);
    void addButtons(QGridLayout& grid);
    void addPedal(QGridLayout& grid);

    QComboBox* devices_;
    QComboBox* seconds_;
    QLabel* state_;
    QLabel* secondDeviceState_;
    NumberRow* motionScaling_ = nullptr;
    QCheckBox* fit_;
    QLabel* fitNote_;
    QComboBox* rate_;
    QPushButton* clutch_;
    QAction* clutchAction_;
    QCheckBox* leftHanded_;
    std::array<QComboBox*, 3> buttons_{};  // swap of turbine and mirror, touch or cut, clutch
    QLabel* pedal_;
    QPushButton* calibrate_;
    QKeySequenceEdit* key_;
    std::string pedalText_;
    double pedalUp_ = 0, pedalDown_ = 1;
};

/// The pedal key; the space key if the settings name none.
[[nodiscard]] Qt::Key pedalKeyOf(const DeviceSettings& settings);

/// A sentence on why the force is on, off or limited.
[[nodiscard]] QString forceStateText(ForceState state);

}  // namespace tactooth
