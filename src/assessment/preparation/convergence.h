// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/preparation/cut_patch.h"
#include "assessment/preparation/measured.h"

namespace tactooth {

/// Total occlusal convergence of a crown preparation in two ways, degrees. On a cone they agree within a degree.
struct Convergence {
    Measured sections;    ///< mean of eight vertical sections round the axis of the preparation
    Measured cone;        ///< of the cone whose axis makes all normals of the axial wall lean alike
    Measured difference;  ///< between the two
};

/// `walls`: the axial wall. `inner`: the same without the rounded angles along its border. Nothing of a cavity.
[[nodiscard]] Convergence convergence(const Preparation& preparation, const CutSurfaces& surfaces,
                                      const CutPatch& walls, const CutPatch& inner);

}  // namespace tactooth
