// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/piece_remover.h"

#include "geometry/util/assert.h"
#include "tooth/volume/brick_carver.h"

// Own method. A detached piece is removed node by node, together with the air around it, so that its thin edges go too.
// Nodes next to solid nodes that stay are left as they are.

namespace tactooth {
namespace {

/// Voxels. How far the search follows an edge that is too thin to hold nodes. An edge between a wall and the tooth's
/// surface ends within this length if they meet at more than 15 degrees.
constexpr int kFringe = 4;
/// Share of a lattice edge: beyond the tooth's surface, wherever it crosses the edge.
constexpr float kBeyondSurface = 0.95F;

NodeSet nodesAt(const NodeSets& sets, const BrickKey& key) {
    const auto found = sets.find(key);
    return found == sets.end() ? NodeSet() : found->second;
}

NodeSet solidAt(const BrickMap& bricks, const BrickKey& key) {
    const Brick* brick = bricks.find(key);
    return brick != nullptr ? solidNodes(*brick) : NodeSet();
}

/// The solid nodes outside the pieces, in the bricks of the pieces and all bricks around them.
NodeSets nodesThatStay(const BrickMap& bricks, const NodeSets& pieces) {
    NodeSets stay;
    for (const auto& [key, nodes] : pieces) {
        for (int i = 0; i < 27; ++i) {
            const BrickKey near = key.neighbour(i);
            if (!stay.contains(near)) stay[near] = solidAt(bricks, near) & ~nodesAt(pieces, near);
        }
    }
    return stay;
}

}  // namespace

NodeSets nodesToRemove(const BrickMap& bricks, const NodeSets& pieces) {
    TACTOOTH_ASSERT(!pieces.empty());
    NodeSets kept = dilated(nodesThatStay(bricks, pieces));
    NodeSets gone;
    for (auto& [key, nodes] : kept) {
        nodes &= ~(nodesAt(pieces, key) & solidAt(bricks, key));
        gone[key] = nodesAt(pieces, key) & ~nodes;
    }
    for (int step = 0; step < kFringe; ++step) {
        gone = dilated(gone);
        for (auto& [key, nodes] : gone) nodes &= ~kept[key];
    }
    return gone;
}

MaterialVolumes removeNodes(Brick& brick, const NodeSet& nodes, double spacing) {
    TACTOOTH_ASSERT(nodes.any());
    MaterialVolumes taken = removedFromBrick(brick, spacing);
    for (double& volume : taken) volume = -volume;
    for (int node = 0; node < kBrickNodes; ++node) {
        if (!nodes[static_cast<std::size_t>(node)]) continue;
        brick.cut[node] = static_cast<float>(-kCutBand * spacing);
        brick.setRemoved(node);
    }
    brick.isCut = true;
    const MaterialVolumes after = removedFromBrick(brick, spacing);
    for (std::size_t i = 0; i < taken.size(); ++i) taken[i] += after[i];
    return taken;
}

void placeBoundary(BrickMap& bricks, const BrickKey& key, const NodeSets& gone) {
    TACTOOTH_ASSERT(bricks.find(key) != nullptr);
    Brick& brick = *bricks.find(key);
    for (int axis = 0; axis < 3; ++axis) {
        const BrickFace upper{axis, true};
        const Brick* next = std::as_const(bricks).find(upper.beyond(key));
        const NodeSet goneHere = nodesAt(gone, key);
        const NodeSet goneNext = nodesAt(gone, upper.beyond(key));
        for (int node = 0; node < kBrickNodes; ++node) {
            const bool isLast = upper.nodes()[static_cast<std::size_t>(node)];
            const int other = node + (isLast ? 1 - kBrickSide : 1) * nodeStride(axis);
            TACTOOTH_ASSERT(other >= 0 && other < kBrickNodes);
            const Brick* const owner = isLast ? next : &brick;
            const bool isGone = goneHere[static_cast<std::size_t>(node)];
            const bool isOtherGone = (isLast ? goneNext : goneHere)[static_cast<std::size_t>(other)];
            if (!isGone && !isOtherGone) continue;
            const bool isRemoved = brick.cut[node] < 0;
            const bool isOtherRemoved = owner != nullptr && owner->cut[other] < 0;
            if (isRemoved == isOtherRemoved) continue;
            brick.boundary[axis][node] = {isGone ? kBeyondSurface : 1 - kBeyondSurface,
                                          OctahedralNormal((isGone ? 1.0 : -1.0) * Vec3::Unit(axis))};
        }
    }
}

}  // namespace tactooth
