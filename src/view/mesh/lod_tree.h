// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/mesh/cluster_culling.h"

namespace tactooth {

/// A piece of a surface that is drawn as a unit: either a piece of the true surface, or the content of its children
/// with half of their triangles.
struct LodNode {
    Vec3f centre;            ///< of a ball that encloses the piece, object frame, mm
    float radius = 0;        ///< mm
    float error = 0;         ///< mm, root mean square distance to the true surface; infinite: not to be drawn
    TriangleRange clusters;  ///< in LodTree::clusters
    std::uint32_t firstChild = 0;
    std::uint32_t children = 0;  ///< 0 to 2; none: the true surface
};

/// A surface that is drawn with as few triangles as the view requires. A piece has the same border edges as the pieces
/// that it replaces, so pieces of any level of detail fit together without a gap. Edges between two appearances are all
/// kept.
struct LodTree {
    std::vector<Triangle> triangles;  ///< those of the shading mesh in their order, then those of the coarser pieces
    std::vector<TriangleCluster> clusters;
    std::vector<LodNode>
        nodes;  ///< true pieces in drawing order, then parents after their children; the last is the root
};

/// Triangles of a piece of the true surface; the last piece has the remainder.
inline constexpr std::uint32_t kTrianglesPerLeaf = 2048;

/// `mesh` has at least one triangle. The coarser pieces also use its vertices.
[[nodiscard]] LodTree buildLodTree(const ShadingMesh& mesh);

/// Adds the pieces that may be visible to `ranges`, as coarse as `culler` allows. Below nodes with `mustRefine` (one
/// entry per node, or empty) it adds pieces of the true surface.
void visibleRanges(const ClusterCuller& culler, const LodTree& tree, const std::vector<bool>& mustRefine,
                   std::vector<TriangleRange>& ranges);

}  // namespace tactooth
