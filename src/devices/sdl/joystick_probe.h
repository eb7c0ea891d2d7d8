// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "devices/probe/device_probe.h"

namespace tactooth {

/// Looks for joysticks in a child process: gamepads alone, or all. `can`: what each can do; its buttons are filled in
/// from the first one. `none`: the sentence for none.
[[nodiscard]] DetectedDevice probeJoysticks(const std::string& name, const char* backend, bool padsOnly,
                                            const DeviceCapabilities& can, const std::string& none);

/// Foot pedals: any joystick will do.
[[nodiscard]] DetectedDevice probePedals();

}  // namespace tactooth
