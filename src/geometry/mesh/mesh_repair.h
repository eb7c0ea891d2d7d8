// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>

#include "geometry/mesh/crack_weld.h"
#include "geometry/mesh/mesh_specks.h"
#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Which holes of a surface `repaired` fills.
enum class HolesToFill { None, Small, All };

/// What `repaired` may change.
struct RepairOptions {
    HolesToFill holes = HolesToFill::Small;
    /// A hole is small if its boundary loop is no longer than this share of the box's diagonal.
    double smallHole = 0.15;
    double speckSize = kSpeck;  ///< components smaller than this share of the largest body are dropped, 0..1
};

/// What was repaired.
struct RepairReport {
    CrackWeld cracks;
    std::size_t droppedDegenerate = 0;  ///< triangles with two equal corners
    /// Triangles that are stored twice or lie back to back (see `removeDuplicates`).
    std::size_t droppedDuplicates = 0;
    std::size_t droppedPieces = 0;     ///< specks beside the surface
    std::size_t flippedTriangles = 0;  ///< to agree with their neighbours, or to point outward
    std::size_t filledHoles = 0;
    double longestFilledRim = 0;  ///< mm
    std::size_t openHoles = 0;    ///< left open: too wide, or with a boundary that does not close

    [[nodiscard]] bool changedAnything() const {
        return cracks.moved + droppedDegenerate + droppedDuplicates + droppedPieces + flippedTriangles + filledHoles >
               0;
    }
};

/// A surface and what was repaired of it.
struct RepairedMesh {
    TriangleMesh mesh;
    RepairReport report;
};

/// Repairs what needs no guess about the shape. It welds corners that rounding has separated, drops duplicate and empty
/// triangles and specks, turns triangles so that neighbours agree and the surface faces outward, and fills holes. A
/// hole is filled by a fan around the mean of its boundary loop, one triangle for each edge. A valid surface is
/// returned unchanged.
[[nodiscard]] RepairedMesh repaired(const TriangleMesh& mesh, const RepairOptions& options = {});

/// The connected components of a surface over common edges, largest box first; vertices are renumbered.
[[nodiscard]] std::vector<TriangleMesh> connectedComponents(const TriangleMesh& mesh);

}  // namespace tactooth
