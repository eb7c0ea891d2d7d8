// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/bvh/surface.h"

namespace tactooth {

/// The triangles that meet another one elsewhere than in the corners or the edge that both have, in ascending order;
/// for meshes with triangles of any sizes. Triangles with two equal corners are left out. Nothing if that takes more
/// than `most` looks at pairs of triangles: where they lie across each other everywhere, they bound no body.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> selfIntersectingTriangles(const SurfacePart& part,
                                                                                  std::uint64_t most);

/// The same with as many looks as any surface needs that bounds a body: some seconds at most.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> selfIntersectingTriangles(const SurfacePart& part);

}  // namespace tactooth
