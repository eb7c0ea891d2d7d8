// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A corner of the outline of a surface of revolution.
struct OutlinePoint {
    double radius = 0, z = 0;  ///< mm
};

/// The closed body that an outline sweeps around the z axis. The outline runs from its lower to its upper end. Both
/// ends are on the axis, and no other point is.
[[nodiscard]] TriangleMesh revolved(std::span<const OutlinePoint> outline, int sides);

}  // namespace tactooth
