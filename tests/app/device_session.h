// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "app/window_session.h"

namespace tactooth::test {

/// The real window steered by a haptic device, whose stand-in has a hand on a spring inside. Whatever it waits for is
/// something that happens, in the device's own time: a busy machine makes it slower and nothing else.
class DeviceSession : public WindowSession {
protected:
    // The stand-in of the device.
    /// Where its hand wants to be, mm to the right of and above where it was when the device was opened.
    virtual void moveHand(double right, double up) const = 0;
    /// Bit i: button i is down.
    virtual void setButtons(unsigned down) const = 0;
    /// That its motors make, N.
    [[nodiscard]] virtual double force() const = 0;
    /// How often it has told its place and been told a force, about once a millisecond.
    [[nodiscard]] virtual long exchanges() const = 0;
    /// 0: all is well.
    virtual void setFault(int fault) const = 0;
    /// The last exchange with a force, counted since the fault began; 0: none.
    [[nodiscard]] virtual long lastForceSinceFault() const = 0;

    // The window.
    [[nodiscard]] QString state() const;
    [[nodiscard]] QString hint() const;
    /// What the messages in front say, which are closed.
    [[nodiscard]] QString dismissMessages() const;
    [[nodiscard]] Vec3 toolTip() const { return window_->model().log().newest().hand.position; }
    [[nodiscard]] Vec3 mirrorMotion() const { return window_->model().simulator()->mirrorMotion().position; }
    void chooseDevice(const char* list, const QString& name) const;

    /// Until what was set in the stand-in and in the window has arrived at the simulation and come back.
    void waitUntilRead() const;
    /// Until the hand, free of the tooth, is where it wants to be.
    void waitForHand() const;
    void clickButton(int button) const;
    void liftOff() const;
    /// As often as it takes until the tooth is felt.
    void lean() const;

    // What every device has to do.
    void touchTheTooth() const;
    /// To and fro for at least so long.
    void cutByButtonAndPedal(int button, double seconds) const;
    void takeTheMirrorByButton(int button) const;
    /// Mid-press: the window says `sentence`, no force is made later than so many exchanges after the fault (none: it
    /// may be), all that was done is kept, and the same device goes on.
    void breakMidPress(int fault, const QString& sentence, std::optional<long> longestForce) const;
};

}  // namespace tactooth::test
