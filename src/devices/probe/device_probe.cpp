// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/probe/device_probe.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "devices/base/messages.h"
#include "devices/probe/child_probe.h"

namespace tactooth {
namespace {

using Json = nlohmann::json;

constexpr double kProbeTimeout = 10;  // s: a driver needs a few seconds to look for its device

/// Rounded to tenths, independent of the locale.
std::string tenths(double value) {
    const long rounded = std::lround(10 * value);
    return std::to_string(rounded / 10) + '.' + std::to_string(rounded % 10);
}

/// JSON text that the child writes into the pipe; an empty list means unknown. A driver may use any characters in the
/// name of its device.
std::string packed(const ProbeResult& result) {
    const DeviceCapabilities& can = result.capabilities;
    const auto list = [](const auto& value) { return value ? Json::array({*value}) : Json::array(); };
    Json workspace = Json::array();
    if (can.workspace) workspace = {can.workspace->x(), can.workspace->y(), can.workspace->z()};
    const Json json = {static_cast<int>(result.state),
                       result.text,
                       list(can.force),
                       list(can.continuousForce),
                       list(can.stiffness),
                       list(can.buttons),
                       workspace};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// No result if a library has ended the child before the text was complete.
std::optional<ProbeResult> unpacked(const std::string& text) {
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) return std::nullopt;
    ProbeResult result{static_cast<DeviceState>(json[0].get<int>()), json[1].get<std::string>()};
    const auto take = [](const Json& list, auto& value) {
        if (!list.empty()) list[0].get_to(value.emplace());
    };
    take(json[2], result.capabilities.force);
    take(json[3], result.capabilities.continuousForce);
    take(json[4], result.capabilities.stiffness);
    take(json[5], result.capabilities.buttons);
    const Json& workspace = json[6];
    if (!workspace.empty()) result.capabilities.workspace = Vec3(workspace[0], workspace[1], workspace[2]);
    return result;
}

}  // namespace

DeviceCapabilities capabilitiesOf(const DeviceInfo& info) {
    DeviceCapabilities capabilities;
    capabilities.force = info.rendersForce ? info.limits.force : 0;
    capabilities.continuousForce = info.rendersForce ? info.limits.continuousForce : 0;
    if (!info.workspace.isZero()) capabilities.workspace = info.workspace;
    if (info.rendersForce && std::isfinite(info.stiffness)) capabilities.stiffness = info.stiffness;
    capabilities.buttons = info.buttonCount;
    return capabilities;
}

std::string capabilityText(const DeviceInfo& info) {
    const Vec3& workspace = info.workspace;
    return info.name + ": force " + tenths(info.limits.force) + " N, " + tenths(info.limits.continuousForce) +
           " N for ever; workspace " + tenths(workspace.x()) + " x " + tenths(workspace.y()) + " x " +
           tenths(workspace.z()) + " mm; stiffest wall " + tenths(info.stiffness) + " N/mm; " +
           std::to_string(info.buttonCount) + " buttons";
}

DetectedDevice probeInChild(const std::string& name, const char* backend, const std::string& library,
                            const std::string& remedy, const std::function<ProbeResult()>& probe) {
    const auto text = inChildProcess([&probe] { return packed(probe()); }, kProbeTimeout);
    const std::optional<ProbeResult> result = text ? unpacked(*text) : std::nullopt;
    if (result) return {name, backend, result->state, result->text, result->capabilities};
    const std::string end = text ? std::string(msg::kEndsTheProgram.english) : text.error().message();
    return {name, backend, DeviceState::Unusable, library + " is broken, " + end + ": " + remedy};
}

}  // namespace tactooth
