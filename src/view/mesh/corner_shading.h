// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "collision/bvh/surface.h"
#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Triangles that meet at a larger angle than this, rad, are shaded with a sharp edge. 40 degrees keeps the blades of a
/// bur and the rim of a cavity sharp and the facets of a scanned tooth smooth.
inline constexpr double kCreaseAngle = 0.70;

/// The two appearances that are mixed at a corner, as surface tags. If more than two meet, these are the two with the
/// largest weights.
struct AppearanceMix {
    SurfaceTag first = 0;
    SurfaceTag second = 0;
    std::uint8_t share = 0;  ///< weight of `second`, in 255ths

    bool operator==(const AppearanceMix&) const = default;
};

/// The shading data of the corners of a mesh. Corner c of triangle t is entry 3 t + c.
struct CornerShading {
    std::vector<Vec3f> normals;  ///< unit
    std::vector<AppearanceMix> appearances;
};

/// Smooth shading. Around a vertex, triangles connected by edges flatter than the crease angle share one normal and one
/// mix of appearances: the weighted means of their own. The weight is the angle at the vertex; slivers weigh less. So
/// materials blend over one triangle instead of along jagged edges, but never across the rim of a cavity. `tags` holds
/// one tag per triangle, or is empty.
///
/// Weights: G. Thuermer, C. A. Wuethrich, Computing vertex normals from polygonal facets, J. Graphics Tools 3(1), 1998.
[[nodiscard]] CornerShading cornerShading(const TriangleMesh& mesh, std::span<const SurfaceTag> tags = {});

}  // namespace tactooth
