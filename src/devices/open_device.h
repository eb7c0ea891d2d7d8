// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "devices/haptic_device.h"

namespace tactooth {

/// Opens the device that a person has named: "pen" is the default one of OpenHaptics, "pen:NAME" the one of that name
/// in the vendor's setup program, "inverse3" the first Haply Inverse3, "inverse3:ID" the one of that name. Fails with
/// one sentence that says what to do.
[[nodiscard]] Expected<std::unique_ptr<HapticDevice>> openDevice(const std::string& name);

}  // namespace tactooth
