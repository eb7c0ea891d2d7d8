// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A place on a tube's centre line and the tube's radius there, mm.
struct TubePoint {
    Vec3 centre;
    double radius;
};

/// The closed body of a round tube through `points`, as they stand: no two of them the same, its bends wider than the
/// tube. Its ends are flat.
[[nodiscard]] TriangleMesh tube(std::span<const TubePoint> points, int sides);

/// More points between these, on a smooth curve through all of them: `steps` for each stretch.
[[nodiscard]] std::vector<TubePoint> smoothed(std::span<const TubePoint> points, int steps);

}  // namespace tactooth
