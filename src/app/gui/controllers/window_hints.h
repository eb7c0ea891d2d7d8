// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "app/gui/controllers/window_panels.h"
#include "geometry/util/message.h"

namespace tactooth {

class DeviceController;
class SessionModel;
class WindowMessages;

/// The hints of the status line about the work: how to use the device, and why the bur does not do what the user
/// expects.
class WindowHints final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the hints.
    WindowHints(SessionModel& model, const WindowPanels& panels, const DeviceController& devices,
                WindowMessages& messages);

    /// How to work with the device in use, or its fault while there is one.
    void showUsual();
    /// A message of a device, which stays while the fault lasts; null: the fault has ended.
    void showFault(const Message* fault);
    /// `microseconds`: the time of the slowest tick in a hundred. Waits for the end of a fault.
    void showOverload(double microseconds);
    /// Shows why the bur does not do what the user expects, if the reason has changed.
    void update();

private:
    enum class Reason { None, ForceWaits, WorkspaceEnd, BurStopped, OnlyTouches };
    [[nodiscard]] Reason reason() const;
    [[nodiscard]] bool holdsHandInstrument() const;
    [[nodiscard]] QString pedalKey() const;
    [[nodiscard]] QString text(Reason reason) const;
    void showPedal(double pedal);
    void showGhost(bool on);

    SessionModel& model_;
    WindowPanels panels_;
    const DeviceController& devices_;
    WindowMessages& messages_;
    Reason shown_ = Reason::None;
    std::optional<Message> fault_;
    std::optional<double> overload_;  // microseconds; waits
};

}  // namespace tactooth
