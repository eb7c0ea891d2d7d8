// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

/// Liquids on an object: a film of water with the slurry of what was ground off, and blood from an opened pulp. Places
/// in the world frame, mm.
struct SurfaceLiquids {
    Vec3 spot = Vec3::Zero();     ///< where the water arrives
    double water = 0;             ///< 0..1: of the film around `spot`; 0: only what the appearances say
    double slurry = 0;            ///< 0..1: how milky the film is near `spot`
    Vec3 opening = Vec3::Zero();  ///< of the pulp
    double blood = 0;             ///< mm: how far blood has spread from `opening`

    bool operator==(const SurfaceLiquids&) const = default;
};

}  // namespace tactooth
