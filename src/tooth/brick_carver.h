// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tooth/cut_volume.h"

namespace tactooth {

/// What one carve does to one brick.
struct BrickCarve {
    MaterialVolumes removed{};
    ChangedBrick changed;
    [[nodiscard]] bool hasChanged() const { return changed.low[0] <= changed.high[0]; }
};

/// Lowers the cut field of `brick` to the distance to the swept steps. `carve` numbers the whole carve.
[[nodiscard]] BrickCarve carveBrick(Brick& brick, const BrickKey& key, const Lattice& lattice,
                                    const std::vector<SweepStep>& steps, std::uint64_t carve);

/// What a carve would remove from one brick, and at which nodes.
struct RemovableInBrick {
    MaterialVolumes volumes{};
    NodesInBrick nodes;
};

/// What carveBrick would remove, without doing it.
[[nodiscard]] RemovableInBrick removableFromBrick(const Brick& brick, const BrickKey& key, const Lattice& lattice,
                                                  const std::vector<SweepStep>& steps);
/// The same where only the given nodes can have something to give.
[[nodiscard]] MaterialVolumes removableFromNodes(const Brick& brick, const NodesInBrick& where, const Lattice& lattice,
                                                 const std::vector<SweepStep>& steps);

/// What has been removed from the tooth within one brick.
[[nodiscard]] MaterialVolumes removedFromBrick(const Brick& brick, double spacing);

}  // namespace tactooth
