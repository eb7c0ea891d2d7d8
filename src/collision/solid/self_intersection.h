// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/bvh/surface.h"

namespace tactooth {

/// The triangles that intersect another one elsewhere than in their common corners or edge, in ascending order; for
/// meshes with triangles of any size. Triangles with two equal corners are left out. std::nullopt if that takes more
/// than `most` tests of pairs: triangles that intersect each other everywhere bound no body.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> selfIntersectingTriangles(const SurfacePart& part,
                                                                                  std::uint64_t most);

/// The same with enough tests for any surface that bounds a body: some seconds at most.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> selfIntersectingTriangles(const SurfacePart& part);

}  // namespace tactooth
