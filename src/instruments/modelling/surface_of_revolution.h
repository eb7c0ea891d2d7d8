// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A corner of a turned part's outline.
struct OutlinePoint {
    double radius = 0, z = 0;  ///< mm
};

/// The closed body that an outline sweeps around the z axis. The outline runs from its lower to its upper end, both of
/// which are on the axis; only these two points may be.
[[nodiscard]] TriangleMesh revolved(std::span<const OutlinePoint> outline, int sides);

}  // namespace tactooth
