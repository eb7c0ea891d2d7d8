// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "assessment/report/assessment_report.h"
#include "geometry/util/message.h"

namespace tactooth {

/// What to do next, in two sentences at most: about the criteria that cost most, a limit of the mark first. One
/// sentence of praise where nothing costs a point.
[[nodiscard]] std::vector<std::string> nextSteps(const AssessmentReport& report, Language language);
[[nodiscard]] inline std::vector<std::string> nextSteps(const AssessmentReport& report) {
    return nextSteps(report, report.language);
}

}  // namespace tactooth
