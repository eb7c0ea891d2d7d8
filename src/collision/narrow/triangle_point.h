// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

/// The point of triangle (a, b, c) nearest to `query`. A triangle without area is treated as its three edges.
[[nodiscard]] Vec3 closestOnTriangle(const Vec3& query, const Vec3& a, const Vec3& b, const Vec3& c);

/// The point of segment (a, b) nearest to `query`.
[[nodiscard]] Vec3 closestOnSegment(const Vec3& query, const Vec3& a, const Vec3& b);

}  // namespace tactooth
