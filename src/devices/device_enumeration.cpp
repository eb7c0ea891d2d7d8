// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/device_enumeration.h"

#include <dlfcn.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "devices/child_probe.h"
#include "devices/haply/haply_connection.h"
#include "devices/haply/haply_device.h"
#include "devices/haply/haply_enumeration.h"
#include "devices/messages.h"
#include "devices/mouse_device.h"
#include "devices/open_device.h"
#include "devices/openhaptics/hd_library.h"
#include "devices/openhaptics/openhaptics_device.h"
#include "devices/openhaptics/pen_names.h"
#include "devices/sdl/gamepad_device.h"
#include "devices/sdl/joysticks.h"
#include "devices/spacemouse/space_mouse_device.h"

namespace tactooth {
namespace {

using Json = nlohmann::json;

constexpr double kConnectTimeout = 10;  // s: a driver that looks for its device takes a few
constexpr double kLinkTimeout = 1;      // s: the service is on this machine

/// Tenths, whatever the locale.
std::string tenths(double value) {
    const long rounded = std::lround(10 * value);
    return std::to_string(rounded / 10) + '.' + std::to_string(rounded % 10);
}

DeviceCapabilities capabilitiesOf(const DeviceInfo& info) {
    DeviceCapabilities capabilities;
    capabilities.force = info.rendersForce ? info.limits.force : 0;
    capabilities.continuousForce = info.rendersForce ? info.limits.continuousForce : 0;
    if (!info.workspace.isZero()) capabilities.workspace = info.workspace;
    if (info.rendersForce && std::isfinite(info.stiffness)) capabilities.stiffness = info.stiffness;
    capabilities.buttons = info.buttonCount;
    return capabilities;
}

/// Of a device that renders force.
std::string textOf(const DeviceInfo& info) {
    const Vec3& room = info.workspace;
    return info.name + ": force " + tenths(info.limits.force) + " N, " + tenths(info.limits.continuousForce) +
           " N for ever; workspace " + tenths(room.x()) + " x " + tenths(room.y()) + " x " + tenths(room.z()) +
           " mm; stiffest wall " + tenths(info.stiffness) + " N/mm; " + std::to_string(info.buttonCount) + " buttons";
}

/// What was found out about a device, in the child process or here.
struct Answer {
    DeviceState state;
    std::string text;
    DeviceCapabilities capabilities = {};
};

/// As the child writes it into the pipe; an empty list: not known. A driver may name its device in any letters.
std::string packed(const Answer& answer) {
    const DeviceCapabilities& can = answer.capabilities;
    const auto list = [](const auto& value) { return value ? Json::array({*value}) : Json::array(); };
    Json room = Json::array();
    if (can.workspace) room = {can.workspace->x(), can.workspace->y(), can.workspace->z()};
    const Json json = {static_cast<int>(answer.state),
                       answer.text,
                       list(can.force),
                       list(can.continuousForce),
                       list(can.stiffness),
                       list(can.buttons),
                       room};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// No answer if a library has ended the child in the middle of it.
std::optional<Answer> unpacked(const std::string& text) {
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) return std::nullopt;
    Answer answer{static_cast<DeviceState>(json[0].get<int>()), json[1].get<std::string>()};
    const auto take = [](const Json& list, auto& value) {
        if (!list.empty()) list[0].get_to(value.emplace());
    };
    take(json[2], answer.capabilities.force);
    take(json[3], answer.capabilities.continuousForce);
    take(json[4], answer.capabilities.stiffness);
    take(json[5], answer.capabilities.buttons);
    const Json& room = json[6];
    if (!room.empty()) answer.capabilities.workspace = Vec3(room[0], room[1], room[2]);
    return answer;
}

/// Asks in a child process. `library`: what is broken if the child does not come to an end; `remedy`: against that.
DetectedDevice survey(const std::string& name, const char* backend, const std::string& library,
                      const std::string& remedy, const std::function<Answer()>& probe) {
    const auto text = inChildProcess([&probe] { return packed(probe()); }, kConnectTimeout);
    const std::optional<Answer> answer = text ? unpacked(*text) : std::nullopt;
    if (answer) return {name, backend, answer->state, answer->text, answer->capabilities};
    const std::string end = text ? std::string(msg::kEndsTheProgram.english) : text.error().message();
    return {name, backend, DeviceState::Unusable, library + " is broken, " + end + ": " + remedy};
}

/// `name`: empty for the default one.
Answer tryPen(const std::string& name, const std::string& library) {
    OpenHapticsDevice pen(name, library);
    const auto opened = pen.open();
    if (opened) return {DeviceState::Ready, textOf(pen.info()), capabilitiesOf(pen.info())};
    const bool isInstalled = dlopen(library.c_str(), RTLD_LAZY | RTLD_NOLOAD) != nullptr;
    const bool isUnplugged = opened.error().contains(msg::kHdLinkFault);
    return {isInstalled && !isUnplugged ? DeviceState::Unusable : DeviceState::NotFound, opened.error().message()};
}

/// One line for each pen that is set up; without any, one for the default pen, which says what to do.
std::vector<DetectedDevice> enumeratePens() {
    const std::string library = HdLibrary::defaultPath();
    std::vector<std::string> pens = configuredPens();
    if (pens.empty()) pens.emplace_back(kDefaultPen);
    std::vector<DetectedDevice> devices;
    for (const std::string& pen : pens) {
        const std::string own = pen == kDefaultPen ? "" : pen;
        devices.push_back(survey(own.empty() ? "pen" : std::string(kNamedPen) + own, "OpenHaptics (PHANToM, Touch)",
                                 library, "install the device's driver anew; Tactooth leaves it alone.",
                                 [&] { return tryPen(own, library); }));
    }
    return devices;
}

/// Why there is no line for an Inverse3: nobody serves it or none is plugged in, or the service cannot be used.
DetectedDevice noInverse3(const char* backend, const std::string& address, const Error& why) {
    const bool isServed =
        !why.contains(msg::kHaplyNoInverse3) && HaplyConnection::open(address, kLinkTimeout).has_value();
    return {"inverse3", backend, isServed ? DeviceState::Unusable : DeviceState::NotFound, why.message()};
}

/// One line for each Inverse3; one that says why not if there is none.
std::vector<DetectedDevice> enumerateInverse3() {
    constexpr const char* kBackend = "Haply Inverse3";
    const std::string address = HaplyDevice::defaultAddress();
    const auto found = enumerateHaply(address);
    if (!found) return {noInverse3(kBackend, address, found.error())};
    std::vector<DetectedDevice> devices;
    for (const HaplyNames& names : *found) {
        HaplyDevice device(names.device);
        const auto opened = device.open();
        devices.push_back({"inverse3:" + names.device, kBackend, opened ? DeviceState::Ready : DeviceState::Unusable,
                           opened ? textOf(device.info()) : opened.error().message(),
                           opened ? capabilitiesOf(device.info()) : DeviceCapabilities()});
    }
    return devices;
}

std::string describe(const JoystickState& joystick) {
    return joystick.name + " (" + std::to_string(joystick.axes.size()) + " axes, " +
           std::to_string(joystick.buttons.size()) + " buttons" + (joystick.rumbles ? ", rumbles" : "") + ")";
}

/// The joysticks of the kind that is asked for, or why there are none. `can`: what each can do beside its buttons, of
/// which the first one's are told.
Answer tryJoysticks(bool padsOnly, DeviceCapabilities can, const std::string& none) {
    const auto joysticks = SdlJoysticks::shared();
    if (!joysticks) return {DeviceState::Unusable, joysticks.error().message()};
    std::string found;
    for (const JoystickState& joystick : (*joysticks)->states()) {
        if (padsOnly && !joystick.isPad) continue;
        if (found.empty()) can.buttons = static_cast<int>(joystick.buttons.size());
        found += (found.empty() ? "" : "; ") + describe(joystick);
    }
    if (found.empty()) return {DeviceState::NotFound, none};
    return {DeviceState::Ready, found, can};
}

Answer trySpaceMouse() {
    SpaceMouseDevice device;
    const auto opened = device.open();
    if (!opened) return {DeviceState::NotFound, opened.error().message()};
    return {DeviceState::Ready, "the driver runs; six axes steer by speed, no force", capabilitiesOf(device.info())};
}

DetectedDevice enumerateMouse() {
    return {"mouse", "mouse and keyboard", DeviceState::Ready,
            "always there; no force: what the hand would feel is shown", capabilitiesOf(MouseDevice(Pose()).info())};
}

}  // namespace

std::vector<DetectedDevice> enumerateDevices() {
    constexpr const char* kSdl = "The library that reads joysticks (SDL 2)";
    constexpr const char* kMendSdl =
        "install the package libsdl2-2.0-0 anew, and use neither gamepad nor joystick until then.";
    std::vector<DetectedDevice> devices = {enumerateMouse()};
    for (DetectedDevice& device : enumeratePens()) devices.push_back(std::move(device));
    for (DetectedDevice& device : enumerateInverse3()) devices.push_back(std::move(device));
    devices.push_back(survey("gamepad", "gamepad (SDL)", kSdl, kMendSdl, [] {
        return tryJoysticks(true, capabilitiesOf(GamepadDevice("").info()), std::string(msg::kNoGamepad.english));
    }));
    devices.push_back(survey("spacemouse", "SpaceMouse (spacenavd)", "The SpaceMouse's library (libspnav)",
                             "install the package libspnav0 anew, and use no SpaceMouse until then.", trySpaceMouse));
    devices.push_back(survey("pedal", "foot pedal (any joystick, SDL)", kSdl, kMendSdl, [] {
        return tryJoysticks(
            false, {},
            "There is no joystick or pedal: plug one in; until then the space key and the slider are the pedal.");
    }));
    return devices;
}

}  // namespace tactooth
