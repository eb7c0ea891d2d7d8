// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/haply/haply_backend.h"

#include "devices/base/messages.h"
#include "devices/haply/haply_connection.h"
#include "devices/haply/haply_device.h"
#include "devices/haply/haply_enumeration.h"
#include "devices/probe/device_probe.h"

namespace tactooth {
namespace {

constexpr const char* kName = "inverse3";
constexpr double kLinkTimeout = 1;  // s: the service is on this machine

/// The reason why no Inverse3 is listed: no service runs, no device is plugged in, or the service is not usable.
DetectedDevice noInverse3(const char* backend, const std::string& address, const Error& why) {
    const bool isServed =
        !why.contains(msg::kHaplyNoInverse3) && HaplyConnection::open(address, kLinkTimeout).has_value();
    return {kName, backend, isServed ? DeviceState::Unusable : DeviceState::NotFound, why.message()};
}

/// One entry for each Inverse3; if there is none, one entry with the reason.
std::vector<DetectedDevice> probeInverse3() {
    constexpr const char* kBackend = "Haply Inverse3";
    const std::string address = HaplyDevice::defaultAddress();
    const auto found = enumerateHaply(address);
    if (!found) return {noInverse3(kBackend, address, found.error())};
    std::vector<DetectedDevice> devices;
    for (const HaplyNames& names : *found) {
        HaplyDevice device(names.device);
        const auto opened = device.open();
        devices.push_back({std::string(kName) + ':' + names.device, kBackend,
                           opened ? DeviceState::Ready : DeviceState::Unusable,
                           opened ? capabilityText(device.info()) : opened.error().message(),
                           opened ? capabilitiesOf(device.info()) : DeviceCapabilities()});
    }
    return devices;
}

std::unique_ptr<HapticDevice> createArm(const DeviceRequest& request) {
    return std::make_unique<HaplyDevice>(request.unit);
}

}  // namespace

DeviceBackend haplyBackend() { return {kName, msg::kHaplyInverse3, "ID", createArm, nullptr, probeInverse3}; }

}  // namespace tactooth
