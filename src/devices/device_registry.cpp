// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "devices/haply/haply_backend.h"
#include "devices/mouse/mouse_backend.h"
#include "devices/openhaptics/openhaptics_backend.h"
#include "devices/probe/device_backend.h"
#include "devices/sdl/gamepad_backend.h"
#include "devices/spacemouse/space_mouse_backend.h"

// The list of all device backends. A new backend needs a folder src/devices/NAME with its device and its NAME_backend.h
// and .cpp (see probe/device_backend.h), this folder in FOLDERS and its sources in SOURCES of CMakeLists.txt, a row
// with its title in a messages.h of its folder, and its include and its line here.

namespace tactooth {

std::span<const DeviceBackend> deviceBackends() {
    static const std::array kBackends = {
        mouseBackend(), openHapticsBackend(), haplyBackend(), gamepadBackend(), spaceMouseBackend(),
    };
    return kBackends;
}

const DeviceBackend* findDeviceBackend(const std::string& name) {
    const auto backends = deviceBackends();
    const auto found = std::ranges::find(backends, name, &DeviceBackend::name);
    return found == backends.end() ? nullptr : &*found;
}

}  // namespace tactooth
