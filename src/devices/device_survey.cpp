// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/device_survey.h"

#include <cmath>
#include <functional>

#include "devices/child_probe.h"
#include "devices/haply/haply_device.h"
#include "devices/haply/haply_survey.h"
#include "devices/openhaptics/hd_library.h"
#include "devices/openhaptics/openhaptics_device.h"
#include "devices/sdl/joysticks.h"
#include "devices/spacemouse/space_mouse_device.h"

namespace tactooth {
namespace {

constexpr double kPatience = 10;  // s: a driver that looks for its device takes a few

/// Tenths, whatever the locale.
std::string tenths(double value) {
    const long rounded = std::lround(10 * value);
    return std::to_string(rounded / 10) + '.' + std::to_string(rounded % 10);
}

std::string abilitiesOf(const DeviceInfo& info) {
    const Vec3& room = info.workspace;
    return info.name + ": force " + tenths(info.limits.force) + " N, " + tenths(info.limits.continuousForce) +
           " N for ever; workspace " + tenths(room.x()) + " x " + tenths(room.y()) + " x " + tenths(room.z()) +
           " mm; stiffest wall " + tenths(info.stiffness) + " N/mm; " + std::to_string(info.buttonCount) + " buttons";
}

/// The child's answer: '+' and what the device can do, or '-' and why it cannot be used.
std::string tryPen(const std::string& library) {
    OpenHapticsDevice pen("", library);
    const auto opened = pen.open();
    return opened ? '+' + abilitiesOf(pen.info()) : '-' + opened.error().message;
}

SurveyedDevice surveyPen() {
    SurveyedDevice pen{"pen", "OpenHaptics (PHANToM, Touch)", false, {}};
    const std::string library = HdLibrary::usualPath();
    const auto answer = inChildProcess([&library] { return tryPen(library); }, kPatience);
    if (!answer) {
        pen.text = hdBrokenText(library, answer.error().message);
    } else if (!answer->empty()) {
        pen.ready = answer->front() == '+';
        pen.text = answer->substr(1);
    }
    return pen;
}

/// One line for each Inverse3; one that says why not if there is none.
std::vector<SurveyedDevice> surveyInverse3() {
    constexpr const char* kBackend = "Haply Inverse3";
    const auto found = surveyHaply(HaplyDevice::usualAddress());
    if (!found) return {{"inverse3", kBackend, false, found.error().message}};
    std::vector<SurveyedDevice> devices;
    for (const HaplyNames& names : *found) {
        HaplyDevice device(names.device);
        const auto opened = device.open();
        devices.push_back({"inverse3:" + names.device, kBackend, opened.has_value(),
                           opened ? abilitiesOf(device.info()) : opened.error().message});
    }
    return devices;
}

std::string describe(const JoystickState& joystick) {
    return joystick.name + " (" + std::to_string(joystick.axes.size()) + " axes, " +
           std::to_string(joystick.buttons.size()) + " buttons" + (joystick.rumbles ? ", rumbles" : "") + ")";
}

/// The child's answer: '+' and the joysticks of the kind that is asked for, or '-' and what to do.
std::string tryJoysticks(bool padsOnly, const std::string& none) {
    const auto joysticks = SdlJoysticks::shared();
    if (!joysticks) return '-' + joysticks.error().message;
    std::string found;
    for (const JoystickState& joystick : (*joysticks)->states()) {
        if (padsOnly && !joystick.isPad) continue;
        found += (found.empty() ? "" : "; ") + describe(joystick);
    }
    return found.empty() ? '-' + none : '+' + found;
}

std::string trySpaceMouse() {
    SpaceMouseDevice device;
    const auto opened = device.open();
    return opened ? "+the driver runs; six axes steer by speed, no force" : '-' + opened.error().message;
}

SurveyedDevice survey(const char* name, const char* backend, const std::function<std::string()>& probe) {
    const auto answer = inChildProcess(probe, kPatience);
    if (!answer) return {name, backend, false, "its system library is broken, " + answer.error().message + "."};
    return {name, backend, !answer->empty() && answer->front() == '+', answer->empty() ? "" : answer->substr(1)};
}

}  // namespace

std::vector<SurveyedDevice> surveyDevices() {
    std::vector<SurveyedDevice> devices = {
        {"mouse", "mouse and keyboard", true, "always there; no force: what the hand would feel is shown"},
        surveyPen()};
    for (SurveyedDevice& device : surveyInverse3()) devices.push_back(std::move(device));
    devices.push_back(survey("gamepad", "gamepad (SDL)", [] {
        return tryJoysticks(true,
                            "There is no gamepad: plug one in or switch it on, and see that you may read /dev/input.");
    }));
    devices.push_back(survey("spacemouse", "SpaceMouse (spacenavd)", trySpaceMouse));
    devices.push_back(survey("pedal", "foot pedal (any joystick, SDL)", [] {
        return tryJoysticks(false, "There is no joystick or pedal: the space key and the slider are the pedal.");
    }));
    return devices;
}

}  // namespace tactooth
