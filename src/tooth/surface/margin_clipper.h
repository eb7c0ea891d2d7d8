// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "collision/bvh/surface.h"
#include "tooth/surface/cavity_wall.h"
#include "tooth/surface/surface_intersection.h"
#include "tooth/surface/triangle_clip.h"
#include "tooth/surface/vertex_groups.h"

namespace tactooth {

/// The intersection of one triangle of the tooth's surface with one triangle of a cavity wall.
struct MarginSegment {
    std::uint32_t base;    ///< triangle of the tooth's surface
    std::uint32_t wall;    ///< triangle of the brick's wall
    std::uint64_t wallId;  ///< number of the wall triangle, unique in the lattice
    FaceIntersection crossing;
};

/// Finds all intersections of a brick's wall with the triangles `near` of the tooth's surface, ordered by base, then
/// wall.
[[nodiscard]] std::vector<MarginSegment> findMargin(const CavityWall& wall, const TriangleMesh& base,
                                                    std::span<const std::uint32_t> near);

/// The part of a wall that lies within the tooth: a mesh with one tag for each triangle.
struct WallPatch {
    TriangleMesh mesh;
    std::vector<SurfaceTag> tags;
    int failures = 0;  ///< number of triangles with inconsistent cut lines; they are kept whole

    /// Whether both have the same triangles and the same tags.
    [[nodiscard]] bool isIdentical(const WallPatch& other) const {
        return tags == other.tags && mesh.triangles == other.mesh.triangles && mesh.vertices == other.mesh.vertices;
    }
};
[[nodiscard]] WallPatch clipWall(CavityWall wall, const std::vector<MarginSegment>& margin, const SurfacePart& base);

/// The margin segments as cut lines of one base triangle. All of `pieces` belong to that triangle.
[[nodiscard]] std::vector<ClipSegment> segmentsOnBase(const std::vector<const MarginSegment*>& pieces);

/// For each edge of a triangle: whether the cut lines that cross it keep its two ends. Nothing for an edge that no line
/// crosses.
[[nodiscard]] std::array<std::optional<EdgeEnds>, 3> endsOfEdges(const std::vector<ClipSegment>& segments,
                                                                 const std::array<bool, 3>& isForward);

}  // namespace tactooth
