// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "assessment/exercise.h"

namespace tactooth {

/// The outline on the surface of a cavity along the fissure, from above; its ends reach the boxes of the plan. Empty
/// where the ridges leave no room. `plan` has a fissure; `outer`: LayeredTooth::ownOuter.
[[nodiscard]] std::vector<Vec3> fissureOutlineOn(const PreparationPlan& plan,
                                                 const std::shared_ptr<const SurfacePart>& outer);

/// An outline at the neck of a tooth along the gum, seen from the cheek (`towardY` 1) or the tongue (-1), as a cavity
/// of Class V has.
[[nodiscard]] std::vector<Vec3> neckOutlineOn(const std::shared_ptr<const SurfacePart>& outer, double towardY);

}  // namespace tactooth
