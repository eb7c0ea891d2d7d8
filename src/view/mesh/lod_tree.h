// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/mesh/cluster_culling.h"

namespace tactooth {

/// A piece of a surface that is drawn as one: either a piece of the true surface, or what its children show with half
/// of their triangles.
struct LodNode {
    Vec3f centre;      ///< of a ball that holds the piece, object frame, mm
    float radius = 0;  ///< mm
    float error = 0;   ///< mm, root mean square: how far it lies from the true surface; infinite = not to be drawn
    TriangleRange clusters;  ///< of LodTree::clusters
    std::uint32_t firstChild = 0;
    std::uint32_t children = 0;  ///< 0 to 2; none = the true surface
};

/// A surface to be drawn with as few triangles as the eye needs. A piece ends in the same edges as what it stands for,
/// so that pieces of any fineness fit together without a gap; where two looks meet, no edge is left out.
struct LodTree {
    std::vector<Triangle> triangles;  ///< the shading mesh's own in their order, then those of the coarser pieces
    std::vector<TriangleCluster> clusters;
    std::vector<LodNode>
        nodes;  ///< true pieces in drawing order, then parents behind their children; the last is the root
};

/// Triangles of a piece of the true surface; the last piece has the rest.
inline constexpr std::uint32_t kTrianglesPerLeaf = 2048;

/// `mesh` has at least one triangle. The coarser pieces use its vertices, too.
[[nodiscard]] LodTree buildLodTree(const ShadingMesh& mesh);

/// Adds to `ranges` what may show, as coarse as `culler` allows, but pieces of the true surface below nodes that
/// `mustRefine` (one a node, or empty).
void visibleRanges(const ClusterCuller& culler, const LodTree& tree, const std::vector<bool>& mustRefine,
                   std::vector<TriangleRange>& ranges);

}  // namespace tactooth
