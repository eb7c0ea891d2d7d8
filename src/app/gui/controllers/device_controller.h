// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <memory>
#include <string>

#include "app/gui/controllers/input_filter.h"
#include "app/gui/controllers/window_panels.h"
#include "app/gui/input/foot_pedal.h"
#include "app/gui/scene/gamepad_navigation.h"
#include "app/gui/settings/window_settings.h"
#include "session/model/session_model.h"
#include "session/model/task.h"

namespace tactooth {

class WindowMessages;

/// The devices of both hands, the foot pedal and the gamepad: opens what the user chooses in the device panel and hands
/// it to the session.
class DeviceController final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the controller.
    DeviceController(QMainWindow& window, SessionModel& model, const WindowPanels& panels, WindowMessages& messages);

    /// Opens a device by its name (see openDevice), which then moves the bur; "mouse" closes it. Shows a message if
    /// that fails; the mouse then moves the bur.
    void openFirst(const QString& name);
    /// The same for the other hand, which begins with the mirror; "none" leaves it empty.
    void openSecond(const QString& name);
    void apply(const DeviceSettings& settings);
    /// The same, but devices that stay are not opened again.
    void change(const DeviceSettings& settings);
    [[nodiscard]] DeviceSettings settings() const;

    /// Reads pedal and gamepad, and takes over opened devices. Call it before each step of the model. `dt`: since the
    /// last step, s.
    void step(double dt);
    /// Shows in the drill bar what a device's button has chosen. Call it after each step of the model.
    void followButtons();
    /// Shows how the devices are.
    void showState();

    [[nodiscard]] bool usesGamepad() const;
    [[nodiscard]] bool isGamepadInPanels() const { return gamepad_.isInPanels(); }
    [[nodiscard]] Qt::Key pedalKey() const { return input_.pedalKey(); }

signals:
    /// The status line should show again how to work with the device.
    void usualHintDue();
    /// The user has moved or pressed something.
    void userActive();

private:
    void readSettings();
    void choosePedal(const DeviceSettings& settings);
    void setCalibrating(bool calibrating);
    void collect();
    void stepPedal();
    void stepGamepad(double dt);

    SessionModel& model_;
    WindowPanels panels_;
    WindowMessages& messages_;
    Task<std::unique_ptr<HapticDevice>> pendingFirst_, pendingSecond_;
    std::string first_ = "mouse", second_ = "none";  // saved with the settings, even if opening has failed today
    FootPedal pedal_;
    GamepadNavigation gamepad_;
    InputFilter input_;
    double disagreesSince_ = 0;  // time of a tick, s: since then bar and device differ about touch or cut
};

}  // namespace tactooth
