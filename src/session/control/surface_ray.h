// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "collision/bvh/surface.h"
#include "geometry/util/ray.h"

namespace tactooth {

/// Outside any tooth whose frame's origin lies in it, mm: where a ray toward its surface begins.
inline constexpr double kFarAway = 60;

/// Distance along `ray` (mm) to the first triangle of `surface` that it meets, from either side; none if it meets no
/// triangle.
[[nodiscard]] std::optional<double> firstHit(const Surface& surface, const Ray& ray);

/// Whether `ray` meets any triangle of `surface`, from either side: quicker than to find the first.
[[nodiscard]] bool meetsAny(const Surface& surface, const Ray& ray);

/// Where a ray meets a surface first.
struct SurfaceHit {
    double distance = 0;         ///< along the ray, mm
    Vec3 normal = Vec3::Zero();  ///< of the triangle there, unit, outward
    bool isAdjacent = false;     ///< it belongs to a body around the tooth
};
/// The same as firstHit, with the normal. A triangle without area is not met.
[[nodiscard]] std::optional<SurfaceHit> firstHitWithNormal(const Surface& surface, const Ray& ray);

/// The same for a line of sight: a closed surface is seen from outside only, as in a picture. An eye inside a gum or
/// behind a jaw sees through it.
[[nodiscard]] std::optional<SurfaceHit> firstSeen(const Surface& surface, const Ray& ray);

/// How deep `place` lies inside `whole`, a closed surface that nothing has been cut from: the distance along `up`
/// (unit) to where it leaves the surface, mm. 0 outside. With the tip of a bur and its shaft it is the depth of the
/// cavity there.
[[nodiscard]] double depthInside(const SurfacePart& whole, const Vec3& place, const Vec3& up);

}  // namespace tactooth
