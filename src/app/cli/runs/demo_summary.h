// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "session/scripts/demonstration.h"
#include "session/simulation/cut_model.h"

namespace tactooth {

/// The summary of the session as JSON for people and programs: lengths mm, forces N, volumes mm^3, times s or us.
[[nodiscard]] std::string demoSummary(const Demonstration& demonstration, const CutModel& piece,
                                      const std::string& tooth, const std::string& bur);

}  // namespace tactooth
