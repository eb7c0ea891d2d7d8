// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A point on the centre line of a tube, and the radius there, mm.
struct TubePoint {
    Vec3 centre;
    double radius;
};

/// The closed body of a round tube through `points`: no two are equal, and the bends are wider than the tube. Its ends
/// are flat.
[[nodiscard]] TriangleMesh tube(std::span<const TubePoint> points, int sides);

/// The points with more points between them, on a smooth curve: `steps` for each interval.
[[nodiscard]] std::vector<TubePoint> smoothed(std::span<const TubePoint> points, int steps);

}  // namespace tactooth
