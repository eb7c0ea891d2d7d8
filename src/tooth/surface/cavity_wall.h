// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "collision/bvh/surface.h"
#include "tooth/surface/wall_vertices.h"
#include "tooth/volume/brick_neighbourhood.h"

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
    std::vector<SurfaceTag> tags;  ///< one a triangle: the material behind it
    /// These are empty where no triangle may cross the tooth's surface.
    std::vector<Place> places;           ///< one a triangle
    std::vector<std::uint64_t> faceIds;  ///< one a triangle, unique in the lattice
    /// For each vertex of triangles that may cross the tooth's surface: a number unique in the lattice ...
    std::vector<std::uint64_t> vertexIds;
    /// ... and -1 where it is surely inside the tooth, 1 surely outside, 0 not known. 0 for all other vertices.
    std::vector<std::int8_t> sides;

    /// Asserts that the lists have one entry each, that corners are vertices of the wall and that the numbers of its
    /// triangles and of the vertices at the tooth's surface occur once. Time in proportion to the wall.
    void validate() const;
};

/// Extracts the wall of the brick `key` from the fields of it and its neighbours.
[[nodiscard]] CavityWall extractWall(const BrickNeighbourhood& nodes, const Lattice& lattice, const BrickKey& key);

}  // namespace tactooth
