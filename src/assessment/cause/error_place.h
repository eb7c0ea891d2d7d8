// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "assessment/cause/error_patch.h"
#include "assessment/preparation/preparation_metrics.h"

namespace tactooth {

/// Gives a place to those of `results` that have a value of the whole preparation: that of the largest error patch that
/// they measure, or of the metric that measures the same at one place. Returns for each result the patch whose place it
/// has got; null: none. The patches are those of `patches`.
[[nodiscard]] std::vector<const ErrorPatch*> placeErrors(std::vector<MetricResult>& results,
                                                         const Preparation& preparation,
                                                         const PreparationMeasures& measures,
                                                         const ErrorPatches& patches);

}  // namespace tactooth
