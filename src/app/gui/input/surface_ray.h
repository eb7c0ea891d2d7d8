// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "collision/bvh/surface.h"
#include "view/camera/camera.h"

namespace tactooth {

/// Distance along `ray` (mm) to the first triangle of `surface` that it meets, from whatever side; nothing if it meets
/// none.
[[nodiscard]] std::optional<double> firstHit(const Surface& surface, const Ray& ray);

}  // namespace tactooth
