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
#include "devices/workspace_fit.h"
#include "geometry/util/message.h"
#include "haptics/force_pipeline.h"
#include "session/control/button_actions.h"

namespace tactooth {

/// What the hand and the foot hold: the device that steers, how finely, its buttons, the clutch, and the pedal.
class DevicePanel final : public QWidget {
    Q_OBJECT

public:
    explicit DevicePanel(QWidget* parent = nullptr);

    [[nodiscard]] DeviceSettings settings() const;
    void set(const DeviceSettings& settings);
    /// The device that is chosen, as openDevice takes it; emits nothing.
    void showDevice(const QString& name) { showChosen(*devices_, name); }
    /// The same for the other hand; "none" is an empty one.
    void showSecondDevice(const QString& name) { showChosen(*seconds_, name); }
    void showPedal(const std::string& pedal, double up, double down);
    void setCalibrating(bool calibrating) { calibrate_->setChecked(calibrating); }

    [[nodiscard]] ButtonMap buttons() const;
    [[nodiscard]] bool clutch() const { return clutch_->isChecked(); }
    /// The clutch with its key, for a menu: the key works wherever the panel is, or if it is closed.
    [[nodiscard]] QAction* clutchAction() { return clutchAction_; }

    /// What the fit to the tooth has come to, if it is chosen; none: nothing has a room that could be fitted.
    void showFit(const std::optional<WorkspaceFit>& fit);
    /// How it goes with the device at the moment; an empty name is the mouse.
    void showState(const QString& device, ForceState force, const Message* faultMessage);
    /// The same for the other hand; nothing is shown for an empty one.
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
    void addNamedPens();
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
    std::array<QComboBox*, 3> buttons_{};  // turbine or mirror, touch or cut, clutch
    QLabel* pedal_;
    QPushButton* calibrate_;
    QKeySequenceEdit* key_;
    std::string pedalText_;
    double pedalUp_ = 0, pedalDown_ = 1;
};

/// The space key if it names none.
[[nodiscard]] Qt::Key pedalKeyOf(const DeviceSettings& settings);

/// Why the hand feels what it feels: a sentence.
[[nodiscard]] QString forceStateText(ForceState state);

}  // namespace tactooth
