// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/bvh/surface.h"

namespace tactooth {

/// What files have of a tooth: `visibleToothMesh` without specks. A speck is a bit that hangs together with nothing,
/// has walls of a cut, and holds less than a cube of `voxel` (mm): dust of a cut, too small for the volume to know its
/// shape, so that it may even cross itself. What no bur has touched stays, however small.
[[nodiscard]] TaggedMesh exportedMesh(const Surface& surface, double voxel);

}  // namespace tactooth
