// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tooth/sweep/swept_envelope.h"
#include "tooth/volume/brick_map.h"
#include "tooth/volume/changed_brick.h"

namespace tactooth {

/// Finds the new crossings of the boundary with the lattice edges of one brick, exactly on the swept envelope. Looks
/// only at edges with an end that carve `carve` has changed. Reads the cut fields of the neighbours and writes this
/// brick only. The brick exists, and `steps` is not empty. Returns the lower ends of the edges whose crossings have
/// moved.
[[nodiscard]] ChangedBrick updateHermiteInBrick(BrickMap& bricks, const BrickKey& key, const Lattice& lattice,
                                                const std::vector<SweepStep>& steps, std::uint64_t carve);

}  // namespace tactooth
