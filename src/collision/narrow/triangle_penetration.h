// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/narrow/triangle3.h"

namespace tactooth {

/// The least translation that separates two intersecting triangles.
struct TrianglePenetration {
    double depth = 0;            ///< mm
    Vec3 normal = Vec3::Zero();  ///< unit: `b` is just free of `a` when moved by `depth` along it
};

/// Depth of `b` in `a`. The two intersect. The depth is infinite if neither has an area.
[[nodiscard]] TrianglePenetration penetrationOf(const Triangle3& a, const Triangle3& b);

}  // namespace tactooth
