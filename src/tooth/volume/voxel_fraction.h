// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/util/vec.h"

namespace tactooth {

/// A half-space relative to a cube: the signed distance of the cube's centre from its plane (in sides of the cube,
/// negative inside), and the unit normal out of it.
struct HalfSpace {
    double distance;
    Vec3 normal;
};

/// The fraction of a unit cube within a half-space, 0..1, exact.
[[nodiscard]] double cubeFraction(const HalfSpace& half);

/// The same for four half-spaces at once. Needs only the absolute components of the normals.
[[nodiscard]] Eigen::Array4d cubeFractions(const Eigen::Array4d& distances,
                                           const std::array<Eigen::Array4d, 3>& absNormals);

/// The fraction of a unit cube within both half-spaces, to about 0.01.
[[nodiscard]] double cubeFraction(const HalfSpace& first, const HalfSpace& second);

}  // namespace tactooth
