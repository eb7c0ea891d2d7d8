// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/open_device.h"

#include <cstdlib>
#include <optional>

#include "devices/base/messages.h"
#include "devices/probe/device_backend.h"
#include "devices/process/hand_process_device.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr const char* kNoDevice = "none";  // for the second hand

std::optional<DeviceHost> chosenHost;

/// A device name as the user enters it: "gamepad:Wireless".
struct DeviceName {
    std::string kind, own;  ///< the text before and after the colon

    explicit DeviceName(const std::string& name)
        : kind(name.substr(0, name.find(':'))), own(name.size() > kind.size() ? name.substr(kind.size() + 1) : "") {}
};

/// The backend of a name; nullptr if there is none, or if the name has a part after the colon and this kind takes none.
const DeviceBackend* backendOf(const DeviceName& name) {
    const DeviceBackend* backend = findDeviceBackend(name.kind);
    const bool isKnown = backend != nullptr && backend->create != nullptr;
    return isKnown && (name.own.empty() || backend->unitWord != nullptr) ? backend : nullptr;
}

/// The names that a device option takes.
Message deviceChoice(bool isSecond) {
    const auto backends = deviceBackends();
    std::string names = isSecond ? kNoDevice : backends.front().name;
    std::vector<std::string> units;
    for (const DeviceBackend& each : backends.subspan(1)) {
        names += std::string(", ") + each.name;
        if (each.unitWord != nullptr) units.push_back(std::string(each.name) + ':' + each.unitWord);
    }
    TACTOOTH_ASSERT(units.size() > 1);
    std::string firstUnits = units.front();
    for (std::size_t i = 1; i + 1 < units.size(); ++i) firstUnits += ", " + units[i];
    return {msg::kDeviceChoice, names, firstUnits, units.back()};
}

Error unknownDevice(const std::string& name, const std::string& option, bool isSecond) {
    return {msg::kUnknownDevice, option, deviceChoice(isSecond), name};
}

}  // namespace

std::string deviceNames(bool isSecond) { return deviceChoice(isSecond).in(Language::English); }

Expected<void> checkDeviceName(const std::string& name, const std::string& option, bool isSecond) {
    const bool isKnown = name == (isSecond ? kNoDevice : deviceBackends().front().name) || isReplay(name) ||
                         backendOf(DeviceName(name)) != nullptr;
    if (isKnown) return {};
    return Unexpected{unknownDevice(name, option, isSecond)};
}

void setDeviceHost(DeviceHost host) { chosenHost = host; }

DeviceHost deviceHost() {
    if (chosenHost) return *chosenHost;
    const char* const inProcess = std::getenv("TACTOOTH_DEVICE_IN_PROCESS");
    return inProcess != nullptr && std::string_view(inProcess) == "1" ? DeviceHost::ThisProcess
                                                                      : DeviceHost::HandProcess;
}

Expected<std::unique_ptr<HapticDevice>> openDevice(const std::string& name, bool leftHanded, double rateHz) {
    if (deviceHost() == DeviceHost::ThisProcess) return openDeviceInProcess(name, leftHanded, rateHz);
    if (backendOf(DeviceName(name)) == nullptr) return Unexpected{unknownDevice(name, "--device", false)};
    HandRequest request;
    request.device = name;
    request.leftHanded = leftHanded;
    request.rateHz = rateHz;
    std::unique_ptr<HapticDevice> device = std::make_unique<HandProcessDevice>(request);
    if (const auto opened = device->open(); !opened) return Unexpected{opened.error()};
    return device;
}

Expected<std::unique_ptr<HapticDevice>> openDeviceInProcess(const std::string& name, bool leftHanded, double rateHz,
                                                            const SampleListener& listener) {
    const DeviceName parts(name);
    const DeviceBackend* const backend = backendOf(parts);
    if (backend == nullptr) return Unexpected{unknownDevice(name, "--device", false)};
    if (backend->trial != nullptr) {
        if (const auto tried = backend->trial(); !tried) return Unexpected{tried.error()};
    }
    std::unique_ptr<HapticDevice> device = backend->create({parts.own, leftHanded, rateHz});
    device->setSampleListener(listener);
    if (const auto opened = device->open(); !opened) return Unexpected{opened.error()};
    return device;
}

}  // namespace tactooth
