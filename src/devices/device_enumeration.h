// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "devices/probe/detected_device.h"

namespace tactooth {

/// Looks for all devices. Vendors' libraries are tried in child processes.
[[nodiscard]] std::vector<DetectedDevice> enumerateDevices();

}  // namespace tactooth
