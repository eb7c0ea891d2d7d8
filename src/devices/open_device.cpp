// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/open_device.h"

#include "devices/openhaptics/hd_library.h"
#include "devices/openhaptics/openhaptics_device.h"

namespace tactooth {

Expected<std::unique_ptr<HapticDevice>> openDevice(const std::string& name) {
    const std::string kind = name.substr(0, name.find(':'));
    const std::string own = name.size() > kind.size() ? name.substr(kind.size() + 1) : std::string();
    if (kind != "pen") {
        return unexpected("there is no device '" + name +
                          "': --device takes 'mouse', 'pen' or 'pen:NAME'; 'tactooth devices' shows what is there.");
    }
    auto pen = std::make_unique<OpenHapticsDevice>(own, HdLibrary::usualPath());
    if (const auto opened = pen->open(); !opened) return Unexpected{opened.error()};
    return std::unique_ptr<HapticDevice>(std::move(pen));
}

}  // namespace tactooth
