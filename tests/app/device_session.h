// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "app/window_session.h"

namespace tactooth::test {

/// The real window with a stand-in of a haptic device, whose hand is on a spring. The tests wait for events in the
/// device's own time: a busy machine only slows them.
class DeviceSession : public WindowSession {
protected:
    // The stand-in of the device.
    /// Moves the rest position of the spring, mm to the right of and above the hand at the opening of the device.
    virtual void moveHand(double right, double up) const = 0;
    /// Bit i: button i is down.
    virtual void setButtons(unsigned down) const = 0;
    /// Of its motors, N.
    [[nodiscard]] virtual double force() const = 0;
    /// Number of exchanges of a position for a force, about one a millisecond.
    [[nodiscard]] virtual long exchanges() const = 0;
    /// 0: no fault.
    virtual void setFault(int fault) const = 0;
    /// Number of the last exchange with a force, counted from the fault on; 0: none.
    [[nodiscard]] virtual long lastForceSinceFault() const = 0;

    // The window.
    [[nodiscard]] QString state() const;
    [[nodiscard]] QString hint() const;
    /// Closes the messages in front and returns their texts.
    [[nodiscard]] QString dismissMessages() const;
    [[nodiscard]] Vec3 toolTip() const { return window_->model().log().newest().input.device.position; }
    [[nodiscard]] Vec3 mirrorMotion() const { return window_->model().runner()->feed().mirrorMotion().position; }
    void chooseDevice(const char* list, const QString& name) const;

    /// Until a change in the stand-in or in the window has reached the simulation and come back.
    void waitUntilRead() const;
    /// Until the hand, clear of the tooth, is at rest.
    void waitForHand() const;
    void clickButton(int button) const;
    void liftOff() const;
    /// Leans on the tooth, repeatedly, until there is a force.
    void lean() const;

    // Behaviour of each device.
    void touchTheTooth() const;
    /// Cuts to and fro for at least `seconds`.
    void cutByButtonAndPedal(int button, double seconds) const;
    void takeTheMirrorByButton(int button) const;
    /// Breaks the device while it presses: the window shows `sentence`, the last force comes at most `longestForce`
    /// exchanges after the fault (none: no limit), all work is kept, and the same device goes on.
    void breakMidPress(int fault, const QString& sentence, std::optional<long> longestForce) const;
};

}  // namespace tactooth::test
