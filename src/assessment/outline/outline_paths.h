// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "assessment/exercise.h"

namespace tactooth {

/// The paths of the bur through a cavity below the outline that PreparationPlan::outline has, with their own heights:
/// from the highest place under it down to the floor, then through the boxes. None where the bur has no room inside,
/// the outline lies beside the tooth, or it does not reach a box. `outer`: LayeredTooth::ownOuter.
[[nodiscard]] std::vector<BurPath> throughOutline(const PreparationPlan& plan,
                                                  const std::shared_ptr<const SurfacePart>& outer);

/// Mean height of the surface under the outline along PreparationPlan::outward, from which the depth of a flat floor
/// counts, at a place inside; nothing where no bur has room or the outline lies beside the tooth.
[[nodiscard]] std::optional<Vec3> outlineReference(const PreparationPlan& plan, const SurfacePart& outer);

/// The middle of a box (y): that of the outline at the axial wall; nothing where the outline does not reach it.
[[nodiscard]] std::optional<double> boxMiddle(const PreparationPlan& plan, const ProximalBox& box, double outside);

}  // namespace tactooth
