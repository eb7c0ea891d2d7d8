// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "devices/probe/device_backend.h"

namespace tactooth {

/// Gamepads that SDL supports.
[[nodiscard]] DeviceBackend gamepadBackend();

}  // namespace tactooth
