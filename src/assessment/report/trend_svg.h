// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "assessment/report/trial_trend.h"
#include "assessment/rubric/rubric.h"
#include "geometry/util/message.h"

namespace tactooth {

/// A drawing (SVG) of this size, mm: the marks with median and interval, and the criteria that cost most.
[[nodiscard]] std::string trendSvg(const TrialTrend& trend, const Rubric& rubric, double width, double height,
                                   Language language);

}  // namespace tactooth
