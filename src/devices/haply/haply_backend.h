// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "devices/probe/device_backend.h"

namespace tactooth {

/// The Haply Inverse3 arm.
[[nodiscard]] DeviceBackend haplyBackend();

}  // namespace tactooth
