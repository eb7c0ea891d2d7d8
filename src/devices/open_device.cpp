// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/open_device.h"

#include "devices/haply/haply_device.h"
#include "devices/openhaptics/hd_library.h"
#include "devices/openhaptics/openhaptics_device.h"

namespace tactooth {

namespace {

template <class Device>
Expected<std::unique_ptr<HapticDevice>> opened(std::unique_ptr<Device> device) {
    if (const auto done = device->open(); !done) return Unexpected{done.error()};
    return std::unique_ptr<HapticDevice>(std::move(device));
}

}  // namespace

Expected<std::unique_ptr<HapticDevice>> openDevice(const std::string& name) {
    const std::string kind = name.substr(0, name.find(':'));
    const std::string own = name.size() > kind.size() ? name.substr(kind.size() + 1) : std::string();
    if (kind == "pen") return opened(std::make_unique<OpenHapticsDevice>(own, HdLibrary::usualPath()));
    if (kind == "inverse3") return opened(std::make_unique<HaplyDevice>(own));
    return unexpected("there is no device '" + name +
                      "': --device takes 'mouse', 'pen', 'pen:NAME', 'inverse3' or 'inverse3:ID'; 'tactooth devices' "
                      "shows what is there.");
}

}  // namespace tactooth
