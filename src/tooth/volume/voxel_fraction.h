// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/util/vec.h"

namespace tactooth {

/// A half-space given by the signed distance of a cube's centre to its border (in cube sides, negative inside) and the
/// unit normal out of it.
struct HalfSpace {
    double distance;
    Vec3 normal;
};

/// Share of a unit cube that lies within a half-space, 0..1, exact.
[[nodiscard]] double cubeFraction(const HalfSpace& half);

/// The same for four half-spaces at once; of the normals the sizes of their components tell all.
[[nodiscard]] Eigen::Array4d cubeFractions(const Eigen::Array4d& distances,
                                           const std::array<Eigen::Array4d, 3>& absNormals);

/// Share of a unit cube that lies within both, to about 0.01.
[[nodiscard]] double cubeFraction(const HalfSpace& first, const HalfSpace& second);

}  // namespace tactooth
