// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "collision/bvh/surface.h"
#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Two triangles that meet at a sharper angle than this, rad, are shaded with an edge between them: 40 degrees keeps
/// the blades of a bur and the rim of a cavity sharp and the facets of a scanned tooth smooth.
inline constexpr double kCreaseAngle = 0.70;

/// Which looks meet at a corner: those of two surface tags. Where more than two meet, the two largest.
struct AppearanceMix {
    SurfaceTag first = 0;
    SurfaceTag second = 0;
    std::uint8_t share = 0;  ///< of `second`, in 255ths

    bool operator==(const AppearanceMix&) const = default;
};

/// What the corners of a mesh hand to the shaders, corner c of triangle t in entry 3 t + c.
struct CornerShading {
    std::vector<Vec3f> normals;  ///< unit
    std::vector<AppearanceMix> appearances;
};

/// Smooth shading. Around a vertex, triangles joined by edges flatter than the crease angle share one normal and one
/// mix of looks: the means of theirs, weighted by their angle at the vertex (splinters by less). Materials so pass into
/// each other over one triangle instead of along its jagged edges, but never around the rim of a cavity. `tags` holds
/// one tag a triangle, or nothing.
///
/// Weights: G. Thuermer, C. A. Wuethrich, Computing vertex normals from polygonal facets, J. Graphics Tools 3(1), 1998.
[[nodiscard]] CornerShading cornerShading(const TriangleMesh& mesh, std::span<const SurfaceTag> tags = {});

}  // namespace tactooth
