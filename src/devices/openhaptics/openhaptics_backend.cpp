// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/openhaptics/openhaptics_backend.h"

#include <dlfcn.h>

#include "devices/base/messages.h"
#include "devices/openhaptics/hd_library.h"
#include "devices/openhaptics/openhaptics_device.h"
#include "devices/openhaptics/pen_names.h"
#include "devices/probe/device_probe.h"

namespace tactooth {
namespace {

constexpr const char* kName = "pen";

/// `name`: empty for the default pen.
ProbeResult probePen(const std::string& name, const std::string& library) {
    OpenHapticsDevice pen(name, library);
    const auto opened = pen.open();
    if (opened) return {DeviceState::Ready, capabilityText(pen.info()), capabilitiesOf(pen.info())};
    const bool isInstalled = dlopen(library.c_str(), RTLD_LAZY | RTLD_NOLOAD) != nullptr;
    const bool isUnplugged = opened.error().contains(msg::kHdLinkFault);
    return {isInstalled && !isUnplugged ? DeviceState::Unusable : DeviceState::NotFound, opened.error().message()};
}

/// One entry for each configured pen; if there is none, one entry for the default pen with the remedy.
std::vector<DetectedDevice> probePens() {
    const std::string library = HdLibrary::defaultPath();
    std::vector<std::string> pens = configuredPens();
    if (pens.empty()) pens.emplace_back(kDefaultPen);
    std::vector<DetectedDevice> devices;
    for (const std::string& pen : pens) {
        const std::string own = pen == kDefaultPen ? "" : pen;
        devices.push_back(probeInChild(
            own.empty() ? kName : std::string(kName) + ':' + own, "OpenHaptics (PHANToM, Touch)", library,
            "install the device's driver anew; Tactooth leaves it alone.", [&] { return probePen(own, library); }));
    }
    return devices;
}

std::unique_ptr<HapticDevice> createPen(const DeviceRequest& request) {
    return std::make_unique<OpenHapticsDevice>(request.unit, HdLibrary::defaultPath(), request.rateHz);
}

std::vector<std::string> namedPens() {
    std::vector<std::string> pens = configuredPens();
    std::erase(pens, kDefaultPen);
    return pens;
}

Expected<void> tryLibrary() { return HdLibrary::probeLibrary(HdLibrary::defaultPath()); }

}  // namespace

DeviceBackend openHapticsBackend() {
    return {kName, msg::kHapticPen, "NAME", createPen, tryLibrary, probePens, namedPens, &msg::kNamedHapticPen};
}

}  // namespace tactooth
