// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/open_device.h"

#include <array>

#include "devices/haply/haply_device.h"
#include "devices/messages.h"
#include "devices/openhaptics/hd_library.h"
#include "devices/openhaptics/openhaptics_device.h"
#include "devices/sdl/gamepad_device.h"
#include "devices/spacemouse/space_mouse_device.h"

namespace tactooth {
namespace {

constexpr const char* kMouse = "mouse";
constexpr const char* kNoDevice = "none";  // for the second hand
constexpr double kDefaultRate = 1000;      // Hz

constexpr std::array<DeviceKind, 5> kKinds = {{
    {kMouse, msg::kMouseAndKeyboard},
    {"pen", msg::kHapticPen},
    {"inverse3", msg::kHaplyInverse3},
    {"gamepad", msg::kGamepad},
    {"spacemouse", msg::kSpaceMouse},
}};

/// `own`: what stands behind the colon.
std::unique_ptr<HapticDevice> makeDevice(const std::string& kind, const std::string& own, bool leftHanded,
                                         double rateHz) {
    if (kind == "pen") return std::make_unique<OpenHapticsDevice>(own, HdLibrary::defaultPath(), rateHz);
    if (kind == "inverse3") return std::make_unique<HaplyDevice>(own);
    if (kind == "gamepad") return std::make_unique<GamepadDevice>(own, leftHanded);
    if (kind == "spacemouse" && own.empty()) return std::make_unique<SpaceMouseDevice>();
    return nullptr;
}

/// A name as a person gives it: "gamepad:Wireless".
struct DeviceName {
    std::string kind, own;  ///< what stands before and behind the colon

    explicit DeviceName(const std::string& name)
        : kind(name.substr(0, name.find(':'))), own(name.size() > kind.size() ? name.substr(kind.size() + 1) : "") {}
};

Error unknownDevice(const std::string& name, const std::string& option, bool isSecond) {
    std::string kinds = isSecond ? "none" : kMouse;
    for (const DeviceKind& each : deviceKinds().subspan(1)) kinds += ", " + std::string(each.name);
    return {msg::kUnknownDevice, option, kinds, name};
}

}  // namespace

std::span<const DeviceKind> deviceKinds() { return kKinds; }

Expected<void> checkDeviceName(const std::string& name, const std::string& option, bool isSecond) {
    const DeviceName parts(name);
    const bool isKnown = name == (isSecond ? kNoDevice : kMouse) || isReplay(name) ||
                         makeDevice(parts.kind, parts.own, false, kDefaultRate) != nullptr;
    if (isKnown) return {};
    return Unexpected{unknownDevice(name, option, isSecond)};
}

Expected<std::unique_ptr<HapticDevice>> openDevice(const std::string& name, bool leftHanded, double rateHz) {
    const DeviceName parts(name);
    std::unique_ptr<HapticDevice> device = makeDevice(parts.kind, parts.own, leftHanded, rateHz);
    if (device == nullptr) return Unexpected{unknownDevice(name, "--device", false)};
    if (parts.kind == "pen") {
        if (const auto tried = HdLibrary::probeLibrary(HdLibrary::defaultPath()); !tried)
            return Unexpected{tried.error()};
    }
    if (const auto opened = device->open(); !opened) return Unexpected{opened.error()};
    return device;
}

}  // namespace tactooth
