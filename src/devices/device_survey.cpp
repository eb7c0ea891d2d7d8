// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/device_survey.h"

#include <cmath>

#include "devices/child_probe.h"
#include "devices/haply/haply_device.h"
#include "devices/haply/haply_survey.h"
#include "devices/openhaptics/hd_library.h"
#include "devices/openhaptics/openhaptics_device.h"

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
        pen.text = library + " is broken, " + answer.error().message +
                   ": install the device's driver anew; Tactooth leaves it alone.";
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

}  // namespace

std::vector<SurveyedDevice> surveyDevices() {
    std::vector<SurveyedDevice> devices = {
        {"mouse", "mouse and keyboard", true, "always there; no force: what the hand would feel is shown"},
        surveyPen()};
    for (SurveyedDevice& device : surveyInverse3()) devices.push_back(std::move(device));
    return devices;
}

}  // namespace tactooth
