// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/devices_command.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "devices/device_enumeration.h"
#include "geometry/util/display_text.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> kStates = {"ready", "not there", "not usable"};

const char* stateOf(const DetectedDevice& device) { return kStates[static_cast<std::size_t>(device.state)]; }

/// An unknown property has no member.
Json jsonOf(const DetectedDevice& device) {
    const DeviceCapabilities& can = device.capabilities;
    Json json = {{"name", displayText(device.name)},
                 {"backend", displayText(device.backend)},
                 {"ready", device.state == DeviceState::Ready},
                 {"state", stateOf(device)}};
    if (can.force) json["force_n"] = *can.force;
    if (can.continuousForce) json["continuous_force_n"] = *can.continuousForce;
    if (can.workspace) json["workspace_mm"] = {can.workspace->x(), can.workspace->y(), can.workspace->z()};
    if (can.stiffness) json["stiffness_n_per_mm"] = *can.stiffness;
    if (can.buttons) json["buttons"] = *can.buttons;
    json["text"] = displayText(device.text);
    return json;
}

void printJson(const std::vector<DetectedDevice>& devices) {
    Json json = Json::array();
    for (const DetectedDevice& device : devices) json.push_back(jsonOf(device));
    print("{}\n", json.dump(1, ' ', false, Json::error_handler_t::replace));
}

void printTable(const std::vector<DetectedDevice>& devices) {
    std::size_t name = 0, backend = 0, state = 0;
    for (const DetectedDevice& device : devices) {
        name = std::max(name, device.name.size());
        backend = std::max(backend, device.backend.size());
        state = std::max(state, std::string_view(stateOf(device)).size());
    }
    for (const DetectedDevice& device : devices) {
        print("{:<{}}  {:<{}}  {:<{}}  {}\n", device.name, name, device.backend, backend, stateOf(device), state,
              device.text);
    }
}

}  // namespace

int runDevices(const DevicesOptions& options) {
    const std::vector<DetectedDevice> devices = enumerateDevices();
    options.json ? printJson(devices) : printTable(devices);
    return kExitOk;
}

}  // namespace tactooth
