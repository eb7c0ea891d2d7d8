// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/open_device.h"

#include <array>

#include "devices/haply/haply_device.h"
#include "devices/openhaptics/hd_library.h"
#include "devices/openhaptics/openhaptics_device.h"
#include "devices/sdl/gamepad_device.h"
#include "devices/spacemouse/space_mouse_device.h"

namespace tactooth {
namespace {

constexpr std::array<DeviceKind, 5> kKinds = {{
    {"mouse", "Mouse and keyboard"},
    {"pen", "Haptic pen (OpenHaptics)"},
    {"inverse3", "Haply Inverse3"},
    {"gamepad", "Gamepad"},
    {"spacemouse", "SpaceMouse"},
}};

/// `own`: what stands behind the colon.
std::unique_ptr<HapticDevice> makeDevice(const std::string& kind, const std::string& own, bool leftHanded,
                                         double rateHz) {
    if (kind == "pen") return std::make_unique<OpenHapticsDevice>(own, HdLibrary::usualPath(), rateHz);
    if (kind == "inverse3") return std::make_unique<HaplyDevice>(own);
    if (kind == "gamepad") return std::make_unique<GamepadDevice>(own, leftHanded);
    if (kind == "spacemouse" && own.empty()) return std::make_unique<SpaceMouseDevice>();
    return nullptr;
}

}  // namespace

std::span<const DeviceKind> deviceKinds() { return kKinds; }

Expected<std::unique_ptr<HapticDevice>> openDevice(const std::string& name, bool leftHanded, double rateHz) {
    const std::string kind = name.substr(0, name.find(':'));
    const std::string own = name.size() > kind.size() ? name.substr(kind.size() + 1) : std::string();
    std::unique_ptr<HapticDevice> device = makeDevice(kind, own, leftHanded, rateHz);
    if (device == nullptr) {
        std::string kinds;
        for (const DeviceKind& each : kKinds) kinds += (kinds.empty() ? "" : ", ") + std::string(each.name);
        return unexpected(
            "there is no device '" + name + "': --device takes " + kinds +
            ", or pen:NAME, inverse3:ID and gamepad:NAME for one of several; 'tactooth devices' shows what is there.");
    }
    if (kind == "pen") {
        if (const auto tried = HdLibrary::tryOut(HdLibrary::usualPath()); !tried) return Unexpected{tried.error()};
    }
    if (const auto opened = device->open(); !opened) return Unexpected{opened.error()};
    return device;
}

}  // namespace tactooth
