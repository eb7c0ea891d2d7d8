// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "collision/bvh/surface.h"

namespace tactooth {

/// The owner of the walls in a brick: the tooth, bodies around it, or either of them.
enum class BrickBodies { Tooth, Adjacent, Either };

/// Decides who may own walls in a brick. `near` are the triangles of `base` that touch the brick, `middle` is its
/// middle, mm. A brick that no surface touches lies within one body.
[[nodiscard]] BrickBodies bodiesIn(const SurfacePart& base, const std::vector<std::uint32_t>& near, const Vec3& middle);

/// Makes the part of a patch. Triangles of bodies around the tooth come last. `patch` has one tag for each triangle.
[[nodiscard]] std::shared_ptr<const SurfacePart> patchPart(TaggedMesh patch, BrickBodies bodies,
                                                           const SurfacePart& base);

}  // namespace tactooth
