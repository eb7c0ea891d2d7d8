// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tooth/volume/brick.h"
#include "tooth/volume/changed_brick.h"
#include "tooth/volume/lattice.h"
#include "tooth/volume/planned_removal.h"

namespace tactooth {

/// Finds what lowering the cut field of `brick` to the distance to the swept steps would do. Changes nothing.
[[nodiscard]] BrickRemoval removableFromBrick(const Brick& brick, const BrickKey& key, const Lattice& lattice,
                                              const std::vector<SweepStep>& steps);
/// The same for steps that reach no other nodes than those found for `whole`.
[[nodiscard]] BrickRemoval removableFromNodes(const Brick& brick, const BrickRemoval& whole, const Lattice& lattice,
                                              const std::vector<SweepStep>& steps);

/// Does what was found. `carve` numbers the whole carve. Returns which nodes it has removed.
[[nodiscard]] ChangedBrick carveBrick(Brick& brick, const BrickRemoval& found, std::uint64_t carve);

/// What has been removed from the tooth within one brick.
[[nodiscard]] MaterialVolumes removedFromBrick(const Brick& brick, double spacing);

}  // namespace tactooth
