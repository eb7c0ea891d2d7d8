// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "tooth/volume/cut_volume.h"

namespace tactooth {

/// Volume fractions of the voxels of one brick, for each material of the tooth's registry, 0..1. The voxel of a node is
/// a cube with the node in its middle and a side of one spacing.
using BrickFractions = std::vector<std::array<float, kBrickNodes>>;

/// A cube of uncut bricks that one material fills.
struct SolidBlock {
    BrickKey first;  ///< the brick with the lowest coordinates
    int side;        ///< in bricks
    MaterialId material;
};

/// A tooth without what burs have removed, as voxels on the lattice of `volume`. Computed from its surfaces and the cut
/// bricks; stores nothing in `volume`.
class RemainingFractions {
public:
    /// Finds the bricks that the surfaces pass through. `volume` must outlive this and must not change.
    explicit RemainingFractions(const CutVolume& volume);

    /// Cubes of bricks that one material fills, in a fixed order.
    [[nodiscard]] const std::vector<SolidBlock>& blocks() const { return blocks_; }
    /// All other bricks that are not empty, in a fixed order.
    [[nodiscard]] const std::vector<BrickKey>& mixed() const { return mixed_; }
    /// The fractions of one of these bricks. Any thread may call it.
    [[nodiscard]] BrickFractions fractionsOf(const BrickKey& key) const;

private:
    void classify(const BrickKey& first, int side, const std::vector<BrickKey>& cut);
    [[nodiscard]] bool isUniform(const Vec3& centre, double reach) const;

    const CutVolume& volume_;
    std::vector<SolidBlock> blocks_;
    std::vector<BrickKey> mixed_;
};

}  // namespace tactooth
