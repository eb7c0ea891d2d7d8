// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "devices/base/haptic_device.h"
#include "devices/probe/detected_device.h"

// What the backends share to find out which devices are there.

namespace tactooth {

/// What a probe has found out about a device.
struct ProbeResult {
    DeviceState state;
    std::string text;  ///< see DetectedDevice
    DeviceCapabilities capabilities = {};
};

/// What a device reports about itself.
[[nodiscard]] DeviceCapabilities capabilitiesOf(const DeviceInfo& info);
/// The same as one sentence; for a device that renders force.
[[nodiscard]] std::string capabilityText(const DeviceInfo& info);

/// Runs a probe in a child process, so that a broken vendor library ends the child alone. `name` and `backend`: see
/// DetectedDevice. `library`: what is broken if the child does not come to an end. `remedy`: what to do about it.
[[nodiscard]] DetectedDevice probeInChild(const std::string& name, const char* backend, const std::string& library,
                                          const std::string& remedy, const std::function<ProbeResult()>& probe);

}  // namespace tactooth
