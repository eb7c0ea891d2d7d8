// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/spacemouse/space_mouse_backend.h"

#include "devices/base/messages.h"
#include "devices/probe/device_probe.h"
#include "devices/spacemouse/space_mouse_device.h"

namespace tactooth {
namespace {

constexpr const char* kName = "spacemouse";

ProbeResult trySpaceMouse() {
    SpaceMouseDevice device;
    const auto opened = device.open();
    if (!opened) return {DeviceState::NotFound, opened.error().message()};
    return {DeviceState::Ready, "the driver runs; six axes steer by speed, no force", capabilitiesOf(device.info())};
}

std::vector<DetectedDevice> probeSpaceMice() {
    return {probeInChild(kName, "SpaceMouse (spacenavd)", "The SpaceMouse's library (libspnav)",
                         "install the package libspnav0 anew, and use no SpaceMouse until then.", trySpaceMouse)};
}

std::unique_ptr<HapticDevice> createSpaceMouse(const DeviceRequest&) { return std::make_unique<SpaceMouseDevice>(); }

}  // namespace

DeviceBackend spaceMouseBackend() {
    return {kName, msg::kSpaceMouse, nullptr, createSpaceMouse, nullptr, probeSpaceMice};
}

}  // namespace tactooth
