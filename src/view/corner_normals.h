// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "collision/surface.h"
#include "geometry/triangle_mesh.h"

namespace tactooth {

/// Two triangles that meet at a sharper angle than this, rad, are shaded with an edge between them: 40 degrees keeps
/// the blades of a bur and the rim of a cavity sharp and the facets of a scanned tooth smooth.
inline constexpr double kCreaseAngle = 0.70;

/// Smooth normals for shading, one for each corner of each triangle (corner c of triangle t is entry 3 t + c), unit.
/// Around a vertex, triangles joined by edges flatter than the crease angle and of the same tag share one normal: the
/// mean of theirs, weighted by their angle at the vertex. `tags` holds one tag a triangle, or nothing.
///
/// Weights: G. Thuermer, C. A. Wuethrich, Computing vertex normals from polygonal facets, J. Graphics Tools 3(1), 1998.
[[nodiscard]] std::vector<Vec3f> cornerNormals(const TriangleMesh& mesh, std::span<const SurfaceTag> tags = {});

/// Corner normals of a patch of a tooth. Where the patch carries on the surface of `base` (pieces of original
/// triangles around a cut), it takes over the normals of `base` (`baseNormals`), so that no seam shows.
[[nodiscard]] std::vector<Vec3f> patchNormals(const SurfacePart& patch, const SurfacePart& base,
                                              std::span<const Vec3f> baseNormals);

}  // namespace tactooth
