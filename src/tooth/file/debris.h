// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/bvh/surface.h"
#include "tooth/volume/node_set.h"

namespace tactooth {

/// Bits of surface that hang together with nothing and hold no node of the lattice: flakes thinner than a voxel, left
/// where a cut ran out through the tooth's own surface. Returns the nodes in the air beside them that no bur has
/// removed: with these gone (nodesToRemove) so are they. `surface` is that of the bricks as they are.
[[nodiscard]] NodeSets nodesBesideDebris(const Surface& surface, const BrickMap& bricks, const Lattice& lattice);

}  // namespace tactooth
