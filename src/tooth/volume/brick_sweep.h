// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/util/assert.h"
#include "tooth/sweep/sweep_lanes.h"
#include "tooth/volume/brick.h"
#include "tooth/volume/lattice.h"

namespace tactooth {

/// Nodes along one side of a block. A brick has eight blocks, which are processed one by one.
inline constexpr int kBlockSide = 4;
inline constexpr int kBlockNodes = kBlockSide * kBlockSide * kBlockSide;
inline constexpr int kBlocks = kBrickNodes / kBlockNodes;

[[nodiscard]] constexpr int placeInBrick(int node, int axis) {
    TACTOOTH_ASSERT(node >= 0 && node < kBrickNodes);
    TACTOOTH_ASSERT(axis >= 0 && axis < 3);
    return node >> (3 * axis) & 7;  // eight nodes a side
}
[[nodiscard]] constexpr int blockOf(int node) {
    return placeInBrick(node, 0) / kBlockSide + 2 * (placeInBrick(node, 1) / kBlockSide) +
           4 * (placeInBrick(node, 2) / kBlockSide);
}
/// Index of a node of a block. `i` = x + 4 y + 16 z.
[[nodiscard]] constexpr int nodeOfBlock(int block, int i) {
    TACTOOTH_ASSERT(block >= 0 && block < kBlocks);
    TACTOOTH_ASSERT(i >= 0 && i < kBlockNodes);
    return nodeIndex(kBlockSide * (block & 1) + i % kBlockSide,
                     kBlockSide * (block >> 1 & 1) + i / kBlockSide % kBlockSide,
                     kBlockSide * (block >> 2) + i / (kBlockSide * kBlockSide));
}

/// The steps of a sweep that come near one brick, and those near one of its blocks at a time.
class BrickSweep {
public:
    /// `reach`: how near to a node, mm. `steps` is not empty and outlives this.
    BrickSweep(const BrickKey& key, const Lattice& lattice, const std::vector<SweepStep>& steps, double reach);

    [[nodiscard]] bool isClear() const { return steps_.empty(); }

    /// The steps that come nearer than `reach` to a node of a block. The last step comes first, since it usually
    /// reaches farthest.
    const std::vector<SweepLanes>& nearNodes(int block, double reach);
    /// The steps that reach lattice edges that begin in a block.
    const std::vector<SweepLanes>& nearEdges(int block);

private:
    const std::vector<SweepLanes>& near(int block, double side, double beyond, double reach);

    Vec3 corner_;
    double spacing_;
    std::vector<const SweepStep*> steps_;
    std::vector<SweepLanes> near_;
};

}  // namespace tactooth
