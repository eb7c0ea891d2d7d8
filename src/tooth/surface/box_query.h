// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "collision/bvh/surface.h"

namespace tactooth {

/// Returns the numbers of the triangles of `part` whose bounding boxes touch `box`, in ascending order.
[[nodiscard]] std::vector<std::uint32_t> trianglesTouching(const SurfacePart& part, const Box3& box);

}  // namespace tactooth
