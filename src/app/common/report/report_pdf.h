// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "assessment/report/assessment_report.h"

namespace tactooth {

class PageTarget;

/// Draws the pages of the report: two, or more for a rubric of very many criteria. No table row and no picture is cut
/// by the end of a page. Needs an application of Qt.
void drawReport(PageTarget& target, const AssessmentReport& report);

/// The same pages, A4, as the bytes of a PDF file. Needs no display.
[[nodiscard]] std::string reportPdf(const AssessmentReport& report);

}  // namespace tactooth
