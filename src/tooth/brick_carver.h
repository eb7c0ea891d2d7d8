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

/// Finds what lowering the cut field of `brick` to the distance to the swept steps would do. Changes nothing.
[[nodiscard]] RemovableInBrick removableFromBrick(const Brick& brick, const BrickKey& key, const Lattice& lattice,
                                                  const std::vector<SweepStep>& steps);
/// The volumes alone, for steps that reach no other nodes than those found for `whole`.
[[nodiscard]] MaterialVolumes removableFromNodes(const Brick& brick, const RemovableInBrick& whole,
                                                 const Lattice& lattice, const std::vector<SweepStep>& steps);

/// Does what was found. `carve` numbers the whole carve.
[[nodiscard]] BrickCarve carveBrick(Brick& brick, const RemovableInBrick& found, std::uint64_t carve);

/// What has been removed from the tooth within one brick.
[[nodiscard]] MaterialVolumes removedFromBrick(const Brick& brick, double spacing);

}  // namespace tactooth
