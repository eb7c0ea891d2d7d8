// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "collision/surface.h"
#include "tooth/brick_neighbourhood.h"

namespace tactooth {

/// The border of the removed region in the cells of one brick, as far as it can lie in the tooth or at its surface:
/// what the wall of a cavity is before it is cut off at the tooth's surface. Normals point into the cavity. The walls
/// of neighbouring bricks meet in vertices of equal number and equal bits.
struct CavityWall {
    enum class Place : std::uint8_t {
        Inside,     ///< wholly within the tooth
        AtSurface,  ///< may cross the tooth's surface
    };
    TriangleMesh mesh;
    std::vector<SurfaceTag> tags;          ///< one a triangle: the material behind it
    std::vector<Place> places;             ///< one a triangle
    std::vector<std::uint64_t> faceIds;    ///< one a triangle, unique in the lattice
    std::vector<std::uint64_t> vertexIds;  ///< one a vertex, unique in the lattice
    std::vector<std::int8_t> sides;        ///< one a vertex: -1 surely inside the tooth, 1 surely outside, 0 not known
};

/// Extracts the wall of the brick `key` from the fields of it and its neighbours.
[[nodiscard]] CavityWall extractWall(const BrickNeighbourhood& nodes, const Lattice& lattice, const BrickKey& key);

/// How far the triangles of a brick's wall can reach beyond the brick's first and last node, in voxels.
inline constexpr double kWallReach = 1.5;

}  // namespace tactooth
