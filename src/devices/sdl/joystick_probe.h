// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "devices/probe/device_probe.h"

namespace tactooth {

/// Looks for joysticks in a child process: only gamepads, or all. `can`: the capabilities of each; the number of
/// buttons is taken from the first one. `none`: the sentence if there is none.
[[nodiscard]] DetectedDevice probeJoysticks(const std::string& name, const char* backend, bool padsOnly,
                                            const DeviceCapabilities& can, const std::string& none);

/// Foot pedals: any joystick counts.
[[nodiscard]] DetectedDevice probePedals();

}  // namespace tactooth
