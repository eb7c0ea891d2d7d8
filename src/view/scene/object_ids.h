// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

// An id picture shows which object each pixel shows, by the rules that the picture itself follows: sections,
// visibility, glass. Transparent objects, layers and ghosts are left out. Red: place in Scene::objects plus one, 0 for
// the background. Green: the bits below. Blue: the share of the light that passes the glass in front, in 255ths.

inline constexpr int kBelowGlass = 1;  ///< below SceneObject::glassAbove: the head of a bur
inline constexpr int kInBall = 2;      ///< in the marked ball

/// A ball in the world frame, mm. Radius 0: none.
struct MarkedBall {
    Vec3 centre = Vec3::Zero();
    double radius = 0;
};

}  // namespace tactooth
