// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/bvh/surface.h"

namespace tactooth {

/// The mesh that is written to files: `visibleToothMesh` without specks. A speck is a component with walls of a cut and
/// a volume of less than a cube of `voxel` (mm). The cut volume cannot resolve its shape, so it may even intersect
/// itself. A component that no bur has touched stays, however small it is.
[[nodiscard]] TaggedMesh exportedMesh(const Surface& surface, double voxel);

}  // namespace tactooth
