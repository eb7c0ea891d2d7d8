// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "tooth/volume/cut_volume.h"

namespace tactooth {

/// How much of the voxel around each node (a cube of one spacing with the node in its middle) is filled with what,
/// 0..1: of each material of the tooth's registry, in one brick.
using BrickFractions = std::vector<std::array<float, kBrickNodes>>;

/// A cube of bricks that one material fills, untouched.
struct SolidBlock {
    BrickKey first;  ///< the lowest
    int side;        ///< in bricks
    MaterialId material;
};

/// A tooth without what burs have removed, as voxels on the lattice of `volume`, made afresh from its surfaces and the
/// bricks that were cut; nothing of it is kept in `volume`.
class RemainingFractions {
public:
    /// Looks where the surfaces run. `volume` outlives this and does not change.
    explicit RemainingFractions(const CutVolume& volume);

    /// Wherever one material fills many bricks. In a fixed order.
    [[nodiscard]] const std::vector<SolidBlock>& blocks() const { return blocks_; }
    /// All other bricks that are not empty, in a fixed order.
    [[nodiscard]] const std::vector<BrickKey>& mixed() const { return mixed_; }
    /// What is in one of them. May be called from many threads.
    [[nodiscard]] BrickFractions fractionsOf(const BrickKey& key) const;

private:
    void classify(const BrickKey& first, int side, const std::vector<BrickKey>& cut);
    [[nodiscard]] bool isUniform(const Vec3& centre, double reach) const;

    const CutVolume& volume_;
    std::vector<SolidBlock> blocks_;
    std::vector<BrickKey> mixed_;
};

}  // namespace tactooth
