// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/device_enumeration.h"

#include "devices/probe/device_backend.h"
#include "devices/sdl/joystick_probe.h"

namespace tactooth {

std::vector<DetectedDevice> enumerateDevices() {
    std::vector<DetectedDevice> devices;
    for (const DeviceBackend& backend : deviceBackends()) {
        for (DetectedDevice& device : backend.probe()) devices.push_back(std::move(device));
    }
    devices.push_back(probePedals());
    return devices;
}

}  // namespace tactooth
