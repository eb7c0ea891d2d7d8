// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "assessment/cavity_metrics.h"
#include "session/simulation/cut_events.h"

namespace tactooth {

/// The results of a student's work.
struct PracticeReport {
    std::string tooth = {};
    std::string task = {};                      ///< name of the exercise, or of the target; empty: free practice
    double seconds = 0;                         ///< since the first contact
    std::optional<CavityProgress> cavity = {};  ///< empty without an ideal cavity
    MaterialVolumes removed{};                  ///< mm^3
    const MaterialRegistry* materials = &builtinMaterials();  ///< of the tooth
    double beside = 0;                                        ///< of that, from other teeth, gum or bone
    std::span<const CutEvent> events = {};
};

/// As a table: quantity,value,unit.
[[nodiscard]] std::string practiceReportCsv(const PracticeReport& report);

}  // namespace tactooth
