// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "devices/base/haptic_device.h"
#include "devices/probe/detected_device.h"

// Shared code of the backends for device enumeration.

namespace tactooth {

/// Result of a probe of a device.
struct ProbeResult {
    DeviceState state;
    std::string text;  ///< see DetectedDevice
    DeviceCapabilities capabilities = {};
};

/// Capabilities that a device reports about itself.
[[nodiscard]] DeviceCapabilities capabilitiesOf(const DeviceInfo& info);
/// The same as one sentence, for a device that renders force.
[[nodiscard]] std::string capabilityText(const DeviceInfo& info);

/// Runs a probe in a child process, so that a broken vendor library ends only the child. `name` and `backend`: see
/// DetectedDevice. `library`: the library to blame if the child does not end properly. `remedy`: the advice for that
/// case.
[[nodiscard]] DetectedDevice probeInChild(const std::string& name, const char* backend, const std::string& library,
                                          const std::string& remedy, const std::function<ProbeResult()>& probe);

}  // namespace tactooth
