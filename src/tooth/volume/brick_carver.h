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

/// Finds what lowering the cut field of `brick` to the distance from the swept steps would remove. Changes nothing.
[[nodiscard]] BrickRemoval removableFromBrick(const Brick& brick, const BrickKey& key, const Lattice& lattice,
                                              const std::vector<SweepStep>& steps);
/// The same for steps that reach no nodes other than those of `whole`.
[[nodiscard]] BrickRemoval removableFromNodes(const Brick& brick, const BrickRemoval& whole, const Lattice& lattice,
                                              const std::vector<SweepStep>& steps);

/// Lowers the cut field as `found` says. `carve` is the number of the carve; it is higher than that of the brick's last
/// carve. Returns which nodes were removed.
[[nodiscard]] ChangedBrick carveBrick(Brick& brick, const BrickRemoval& found, std::uint64_t carve);

/// The volumes removed from the tooth within one brick, mm^3. `spacing` in mm.
[[nodiscard]] MaterialVolumes removedFromBrick(const Brick& brick, double spacing);

}  // namespace tactooth
