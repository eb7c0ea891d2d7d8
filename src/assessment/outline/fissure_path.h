// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "assessment/exercise.h"
#include "assessment/outline/crown_view.h"

namespace tactooth {

/// The middle of a cavity along the fissure, from -x to +x; z is 0.
struct FissureMiddle {
    std::vector<Vec3> path;       ///< tooth frame, mm; empty where the ridges leave no room
    std::vector<double> boxesAt;  ///< y of the middle of each box of the plan
};
/// `plan` has a fissure.
[[nodiscard]] FissureMiddle fissureMiddle(const PreparationPlan& plan, const CrownView& crown);

/// The passes of the bur through a box, from the pulpal floor down, with depths below the surface as that of the floor;
/// `middle`: y of the box; `floor`: height of the pulpal floor, which is `depth` below the surface, mm.
[[nodiscard]] std::vector<BurPath> throughBox(const ProximalBox& box, double burRadius, double depth,
                                              const CrownView& crown, double middle, double floor);

}  // namespace tactooth
