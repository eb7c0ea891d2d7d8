// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>

#include "geometry/mesh/crack_weld.h"
#include "geometry/mesh/mesh_specks.h"
#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

enum class HolesToFill { None, Small, All };

struct RepairOptions {
    HolesToFill holes = HolesToFill::Small;
    double smallHole = 0.15;    ///< a hole is small if its rim is no longer than this part of the box's diagonal
    double speckSize = kSpeck;  ///< pieces smaller than this part of the largest body are dropped
};

/// What was mended.
struct RepairReport {
    CrackWeld cracks;
    std::size_t droppedDegenerate = 0;  ///< triangles with two equal corners
    std::size_t droppedDuplicates =
        0;                             ///< triangles that are stored twice or lie back to back (see `removeDuplicates`)
    std::size_t droppedPieces = 0;     ///< crumbs beside the surface
    std::size_t flippedTriangles = 0;  ///< to agree with their neighbours, or to point outward
    std::size_t filledHoles = 0;
    double longestFilledRim = 0;  ///< mm
    std::size_t openHoles = 0;    ///< left open: too wide, or with a rim that does not close

    [[nodiscard]] bool changedAnything() const {
        return cracks.moved + droppedDegenerate + droppedDuplicates + droppedPieces + flippedTriangles + filledHoles >
               0;
    }
};

struct RepairedMesh {
    TriangleMesh mesh;
    RepairReport report;
};

/// Mends what can be mended without a guess at the shape: welds corners that rounding has parted, drops doubled and
/// empty triangles and crumbs, turns triangles so that neighbours agree and the surface looks outward, and fills holes.
/// A hole is filled by a fan around the middle of its rim, triangle for rim edge. A sound surface comes back as it was.
[[nodiscard]] RepairedMesh repaired(const TriangleMesh& mesh, const RepairOptions& options = {});

/// The pieces of a surface that hang together over common edges, largest box first; vertices are numbered anew.
[[nodiscard]] std::vector<TriangleMesh> connectedComponents(const TriangleMesh& mesh);

}  // namespace tactooth
