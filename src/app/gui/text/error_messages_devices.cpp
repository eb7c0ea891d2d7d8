// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "app/gui/text/error_messages.h"

namespace tactooth {
namespace {

constexpr const char* kErrors[] = {
    // Devices.
    QT_TRANSLATE_NOOP(
        "Error", "%1: Tactooth knows no device %2; the usual one takes its place, choose another in the panel Hand."),
    QT_TRANSLATE_NOOP("Error",
                      "%1 takes %2, pen:NAME, inverse3:ID or gamepad:NAME for one of several, or replay:FILE.csv, not "
                      "'%3'; 'tactooth devices' shows what is there."),
    QT_TRANSLATE_NOOP("Error",
                      "the pedal '%1' is none: it is axis:N or button:N of a joystick (N from 0 to 31), with :NAME of "
                      "the joystick behind it if there are several."),
    QT_TRANSLATE_NOOP("Error",
                      "There is no gamepad%1: plug one in or switch it on, and see that you may read /dev/input."),
    QT_TRANSLATE_NOOP("Error", " named '%1'"),
    QT_TRANSLATE_NOOP("Error", "Joysticks cannot be read (%1)."),
    QT_TRANSLATE_NOOP("Error", "A gamepad steers already; there is one for each program."),
    QT_TRANSLATE_NOOP("Error", "A SpaceMouse steers already; there is one for each program."),
    QT_TRANSLATE_NOOP("Error",
                      "The SpaceMouse's driver does not run: install spacenavd, start it (sudo systemctl start "
                      "spacenavd) and plug the SpaceMouse in."),
    QT_TRANSLATE_NOOP("Error", "OpenHaptics, %1: %2"),
    QT_TRANSLATE_NOOP("Error", "the default device"),
    QT_TRANSLATE_NOOP("Error", "the device '%1'"),
    QT_TRANSLATE_NOOP("Error", "OpenHaptics knows no device for %1: look its name up in the vendor's setup program."),
    QT_TRANSLATE_NOOP("Error",
                      "OpenHaptics knows no device for %1: choose one that is set up (%2), or set it up in the "
                      "vendor's setup program."),
    QT_TRANSLATE_NOOP("Error", "OpenHaptics: four devices are in use already; close one of them."),
    QT_TRANSLATE_NOOP(
        "Error",
        "%1 cannot be loaded (%2): install the device's driver and OpenHaptics, or set TACTOOTH_LIBHD to the library."),
    QT_TRANSLATE_NOOP("Error", "%1 has no function %2: it is another version; install OpenHaptics 3.4 or newer."),
    QT_TRANSLATE_NOOP("Error",
                      "The Haply Inverse Service does not answer at %1: install and start it, or set TACTOOTH_HAPLY to "
                      "where it listens."),
    QT_TRANSLATE_NOOP("Error",
                      "What answers at %1 is not the Haply Inverse Service: end that program, or set TACTOOTH_HAPLY to "
                      "where the service listens."),
    QT_TRANSLATE_NOOP("Error", "%1 is broken, %2: install the device's driver anew; Tactooth leaves it alone."),
    QT_TRANSLATE_NOOP("Error", "it crashes (%1)"),
    QT_TRANSLATE_NOOP("Error", "it does not return"),
    QT_TRANSLATE_NOOP("Error", "it ends the program that uses it"),
    QT_TRANSLATE_NOOP("Error", "it closes what it has not opened"),
    QT_TRANSLATE_NOOP("Error", "The Haply Inverse Service finds no Inverse3: check its cable and power supply."),
    QT_TRANSLATE_NOOP("Error", "The Haply Inverse Service knows no Inverse3 '%1': it finds %2."),
    // Troubles of a device that steers.
    QT_TRANSLATE_NOOP("Error", "The motors are warm: rest the pen for a minute; until then the force is weaker."),
    QT_TRANSLATE_NOOP("Error", "The driver has cut a force that was too strong; press more gently."),
    QT_TRANSLATE_NOOP("Error",
                      "The driver has cut a force that rose too fast; move the pen more slowly into the tooth."),
    QT_TRANSLATE_NOOP("Error", "The pen was moved faster than its driver allows; the force comes back by itself."),
    QT_TRANSLATE_NOOP("Error", "The driver reports a force error: switch the device off and on again."),
    QT_TRANSLATE_NOOP("Error",
                      "The device reports a fault: check its power supply and cable, then switch it off and on again."),
    QT_TRANSLATE_NOOP("Error", "The device is in use: close the other program that holds it."),
    QT_TRANSLATE_NOOP("Error",
                      "The device does not answer: check its cable and power supply; it is tried again every second."),
    QT_TRANSLATE_NOOP("Error", "The device is not set up: run the vendor's setup program and pair it."),
    QT_TRANSLATE_NOOP("Error", "The driver's timer does not run: start the vendor's service, or restart the computer."),
    QT_TRANSLATE_NOOP("Error", "The driver takes no more work: close other programs that use the device."),
    QT_TRANSLATE_NOOP("Error", "The vendor's library finds no licence: install OpenHaptics with its licence."),
    QT_TRANSLATE_NOOP("Error",
                      "The device's driver reports an error: switch the device off and on again and restart Tactooth."),
    QT_TRANSLATE_NOOP("Error", "Put the pen into its inkwell for a moment, so that the device learns where it is."),
    QT_TRANSLATE_NOOP(
        "Error",
        "The device has stopped answering: check its cable and power supply; the session goes on when it is back."),
    QT_TRANSLATE_NOOP("Error", "The gamepad has been unplugged: plug it in again, and the session goes on."),
    QT_TRANSLATE_NOOP("Error",
                      "The SpaceMouse's driver has stopped: start it again (sudo systemctl start spacenavd), and the "
                      "session goes on."),
    QT_TRANSLATE_NOOP(
        "Error", "The Haply Inverse Service answers too slowly: close other programs that keep this machine busy."),
    QT_TRANSLATE_NOOP(
        "Error",
        "The Haply Inverse Service has closed the connection: start it again; it is tried again every second."),
    QT_TRANSLATE_NOOP("Error",
                      "The Haply Inverse Service has stopped answering: restart it; it is tried again every second."),
    QT_TRANSLATE_NOOP(
        "Error",
        "The Haply Inverse Service sends what is no message: restart it; if that does not help, install it anew."),
    QT_TRANSLATE_NOOP("Error", "The Haply Inverse Service speaks another version of its language: install version 3."),
    QT_TRANSLATE_NOOP("Error",
                      "The Haply Inverse Service tells places that are not in metres: install version 3 of it."),
    QT_TRANSLATE_NOOP("Error",
                      "The Inverse3 does not know where it is: put its arms into their rest position and switch it off "
                      "and on again."),
    QT_TRANSLATE_NOOP("Error",
                      "The Inverse3 is gone: check its cable and power supply; the session goes on when it is back."),
    QT_TRANSLATE_NOOP("Error", "The Inverse3 has no power: plug in its power supply."),
    QT_TRANSLATE_NOOP("Error",
                      "The Inverse3 is not calibrated: hold its arms in their rest position until its light stays on."),
    QT_TRANSLATE_NOOP("Error", "The Inverse3 is not ready: wait for its light, or switch it off and on again."),
    QT_TRANSLATE_NOOP("Error", "The VerseGrip is asleep: press one of its buttons."),
    QT_TRANSLATE_NOOP("Error",
                      "The device tells a place that is no number: switch it off and on again if this comes again."),
    QT_TRANSLATE_NOOP("Error",
                      "The device's place has jumped: check its cable, and let it calibrate if this comes again."),
    QT_TRANSLATE_NOOP("Error",
                      "The device's driver calls far too often, so the force is off: restart the vendor's service, or "
                      "the computer."),
    QT_TRANSLATE_NOOP("Error",
                      "The device tells a direction that is none: switch it off and on again if this comes again."),
    QT_TRANSLATE_NOOP("Error",
                      "The device moved faster than 1.5 m/s at the tooth, so its force is off: lift the bur, and check "
                      "the cable if the hand was slow."),
    QT_TRANSLATE_NOOP("Error", "The device's direction has jumped: switch it off and on again if this comes again."),
    QT_TRANSLATE_NOOP("Error", "The device's places come too late: close other programs that keep this machine busy."),
    QT_TRANSLATE_NOOP(
        "Error",
        "The force came out as no number and was switched off: lift the bur, and report it to the authors "
        "if this comes again."),
    QT_TRANSLATE_NOOP("Error",
                      "The VerseGrip tells a direction that is none: switch it off and on again if this comes again."),
    QT_TRANSLATE_NOOP("Error",
                      "The Haply Inverse Service sends more answers than it is asked for, so the force is off: restart "
                      "the service."),
};

}  // namespace

std::span<const char* const> deviceErrors() { return kErrors; }

}  // namespace tactooth
