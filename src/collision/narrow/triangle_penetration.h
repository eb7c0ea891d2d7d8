// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/narrow/triangle3.h"

namespace tactooth {

/// The least translation that parts two triangles which intersect.
struct TrianglePenetration {
    double depth = 0;            ///< mm
    Vec3 normal = Vec3::Zero();  ///< unit: moving `b` by depth along it just frees it from `a`
};

/// Depth of `b` in `a`. Both have area; they intersect.
[[nodiscard]] TrianglePenetration penetrationOf(const Triangle3& a, const Triangle3& b);

}  // namespace tactooth
