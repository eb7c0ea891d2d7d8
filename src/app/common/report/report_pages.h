// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <vector>

#include "assessment/report/assessment_report.h"

namespace tactooth {

/// The pages of the PDF file as pictures, `width` pixels wide. Text and lines are where the file has them. Needs an
/// application of Qt.
[[nodiscard]] std::vector<QImage> reportPages(const AssessmentReport& report, int width);

}  // namespace tactooth
