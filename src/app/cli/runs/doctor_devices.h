// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/cli/runs/doctor_finding.h"

namespace tactooth {

/// Checks the program that holds the devices, with its last faults, and looks for all devices.
[[nodiscard]] std::vector<Finding> checkDevices();

}  // namespace tactooth
