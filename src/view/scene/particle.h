// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

/// A drop or a chip in the air: a soft ball drawn facing the eye, or the streak that it leaves while the eye takes a
/// picture.
struct Particle {
    Vec3f position = Vec3f::Zero();  ///< world, mm
    float radius = 0.1F;             ///< mm
    Vec3f colour = Vec3f::Ones();    ///< sRGB
    float opacity = 1;               ///< at its centre, 0..1; a streak is as much fainter as it is larger
    Vec3f streak = Vec3f::Zero();    ///< world, mm: from its end to `position`

    bool operator==(const Particle&) const = default;
};

}  // namespace tactooth
