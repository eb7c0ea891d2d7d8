// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "assessment/preparation/preparation.h"
#include "assessment/report/assessment_report.h"
#include "geometry/util/message.h"

namespace tactooth {

/// The preparation enlarged and five views of the prepared tooth, coloured by the distance to the ideal one; a part
/// that lies within `tolerance` (mm) is white. Fails with one sentence where there is no OpenGL.
[[nodiscard]] Expected<std::vector<ReportPicture>> reportPictures(const Preparation& preparation,
                                                                  const CutSurfaces& surfaces, double tolerance,
                                                                  Language language = Language::English);

}  // namespace tactooth
