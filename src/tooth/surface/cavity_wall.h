// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "collision/bvh/surface.h"
#include "tooth/surface/wall_vertices.h"
#include "tooth/volume/brick_neighbourhood.h"

namespace tactooth {

/// The boundary of the removed region in the cells of one brick, as far as it can lie in the tooth or at its surface.
/// It is the cavity wall before it is clipped at the tooth's surface. Normals point into the cavity. Walls of
/// neighbouring bricks share vertices with equal numbers and equal bits.
struct CavityWall {
    enum class Place : std::uint8_t {
        Inside,     ///< wholly within the tooth
        AtSurface,  ///< may cross the tooth's surface
    };
    TriangleMesh mesh;
    std::vector<SurfaceTag> tags;  ///< for each triangle: the material behind it
    /// The following lists are empty if no triangle may cross the tooth's surface.
    std::vector<Place> places;           ///< for each triangle
    std::vector<std::uint64_t> faceIds;  ///< for each triangle, unique in the lattice
    /// For each vertex of a triangle that may cross the tooth's surface: its number, unique in the lattice.
    std::vector<std::uint64_t> vertexIds;
    /// For each vertex of the wall, its side of the tooth's surface: -1 certainly inside, 1 certainly outside, 0
    /// unknown or not needed.
    std::vector<std::int8_t> sides;

    /// Asserts that all lists have one entry each, that corners are vertices of the wall, and that the numbers of
    /// triangles and of vertices at the tooth's surface are unique. Takes time in proportion to the size of the wall.
    void validate() const;
};

/// Extracts the wall of the brick `key` from the fields of the brick and its neighbours.
[[nodiscard]] CavityWall extractWall(const BrickNeighbourhood& nodes, const Lattice& lattice, const BrickKey& key);

}  // namespace tactooth
