// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "collision/bvh/surface.h"

namespace tactooth {

/// Whose cut walls a brick can hold: those of the tooth, of bodies around it, or of either.
enum class BrickBodies { Tooth, Adjacent, Either };

/// `near`: the triangles of `base` that touch the brick; `middle`: of the brick, mm. Where no surface is near, a brick
/// lies within one body.
[[nodiscard]] BrickBodies bodiesIn(const SurfacePart& base, const std::vector<std::uint32_t>& near, const Vec3& middle);

/// The part for what cutting has left in a brick, the triangles of bodies around the tooth last.
[[nodiscard]] std::shared_ptr<const SurfacePart> patchPart(TaggedMesh patch, BrickBodies bodies,
                                                           const SurfacePart& base);

}  // namespace tactooth
