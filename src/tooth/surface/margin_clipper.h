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

/// Where one triangle of the tooth's surface crosses one of a cavity's wall.
struct MarginSegment {
    std::uint32_t base;    ///< triangle of the tooth's surface
    std::uint32_t wall;    ///< triangle of the brick's wall
    std::uint64_t wallId;  ///< its number in the lattice
    FaceIntersection crossing;
};

/// Finds all crossings of a brick's wall with the triangles of the tooth's surface near it, ordered by base, then wall.
[[nodiscard]] std::vector<MarginSegment> findMargin(const CavityWall& wall, const TriangleMesh& base,
                                                    std::span<const std::uint32_t> near);

/// The part of a wall that lies within the tooth, as one mesh with a tag a triangle.
struct WallPatch {
    TriangleMesh mesh;
    std::vector<SurfaceTag> tags;
    int failures = 0;  ///< triangles whose cut lines did not fit together; they are left whole

    /// The same triangles with the same tags.
    [[nodiscard]] bool isIdentical(const WallPatch& other) const {
        return tags == other.tags && mesh.triangles == other.mesh.triangles && mesh.vertices == other.mesh.vertices;
    }
};
[[nodiscard]] WallPatch clipWall(CavityWall wall, const std::vector<MarginSegment>& margin, const SurfacePart& base);

/// The view of the crossings from a base triangle; `pieces` all belong to it.
[[nodiscard]] std::vector<ClipSegment> segmentsOnBase(const std::vector<const MarginSegment*>& pieces);

/// What the cut lines that cross the edges of a triangle tell about their ends; nothing for an edge without any.
[[nodiscard]] std::array<std::optional<EdgeEnds>, 3> endsOfEdges(const std::vector<ClipSegment>& segments,
                                                                 const std::array<bool, 3>& isForward);

}  // namespace tactooth
