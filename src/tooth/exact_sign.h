// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec.h"

namespace tactooth {

/// Exact sign (-1, 0, 1) of det[b - a, c - a, d - a]: positive if d lies on the side of the plane a, b, c to which
/// (b - a) x (c - a) points.
[[nodiscard]] int orientationSign(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d);

/// Exact sign of component `axis` of (b - a) x (d - c).
[[nodiscard]] int crossProductSign(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d, int axis);

}  // namespace tactooth
