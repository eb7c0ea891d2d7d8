// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tooth/volume/changed_brick.h"
#include "tooth/volume/material_volumes.h"

namespace tactooth {

struct CarveResult {
    MaterialVolumes removed{};
    std::vector<ChangedBrick> changed;  ///< in ascending order of their keys
};

/// Pieces that burs have cut off all around and that are no longer there.
struct DetachedPieces {
    std::vector<double> volumes;  ///< of each, mm^3, to a voxel or so at its surface
    CarveResult carve;            ///< what went with them
};

}  // namespace tactooth
