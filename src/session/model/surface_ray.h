// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "collision/bvh/surface.h"
#include "geometry/util/ray.h"

namespace tactooth {

/// Distance along `ray` (mm) to the first triangle of `surface` that it meets, from either side; none if it meets no
/// triangle.
[[nodiscard]] std::optional<double> firstHit(const Surface& surface, const Ray& ray);

}  // namespace tactooth
