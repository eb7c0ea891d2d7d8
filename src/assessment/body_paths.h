// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "assessment/exercise.h"

namespace tactooth {

/// The paths of the bur through the body that PreparationPlan::body names, layer by layer down to its bottom; none
/// where the tooth has no such body, or only one that is narrower than the bur. `outer`: LayeredTooth::ownOuter.
[[nodiscard]] std::vector<BurPath> throughBody(const PreparationPlan& plan, const LayeredTooth& tooth,
                                               const SurfacePart& outer);

}  // namespace tactooth
