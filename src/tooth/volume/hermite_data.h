// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tooth/sweep/swept_envelope.h"
#include "tooth/volume/brick_map.h"
#include "tooth/volume/changed_brick.h"

namespace tactooth {

/// Finds where the border of the removed region now crosses the lattice edges of one brick, exactly on the envelope
/// that was swept there. Only edges with an end that carve `carve` has changed are looked at; reads the neighbours' cut
/// fields, writes this brick alone. Returns the lower ends of the edges on which the border has moved.
[[nodiscard]] ChangedBrick updateHermiteInBrick(BrickMap& bricks, const BrickKey& key, const Lattice& lattice,
                                                const std::vector<SweepStep>& steps, std::uint64_t carve);

}  // namespace tactooth
