// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/cli/runs/doctor_finding.h"

namespace tactooth {

/// Checks the sound system (the library) and the sound card. Tries both in child processes: call it while the program
/// has one thread.
[[nodiscard]] std::vector<Finding> checkSound();

}  // namespace tactooth
