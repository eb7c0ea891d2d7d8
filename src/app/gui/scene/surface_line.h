// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "collision/bvh/surface.h"

namespace tactooth {

/// The line through `points` as it runs over a surface, seen along `outward` (unit); the end of a closed one is its
/// beginning. Where there is no surface below it, it is straight.
[[nodiscard]] std::vector<Vec3> lineOnSurface(const std::vector<Vec3>& points, const Vec3& outward, bool isClosed,
                                              const std::shared_ptr<const SurfacePart>& surface);

}  // namespace tactooth
