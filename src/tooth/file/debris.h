// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/bvh/surface.h"
#include "tooth/volume/brick_map.h"
#include "tooth/volume/lattice.h"
#include "tooth/volume/node_set.h"

namespace tactooth {

/// Finds debris: components of the surface that hold no node of the lattice. These are flakes thinner than a voxel,
/// left where a cut ran out through the tooth's own surface. Returns the nodes in the air beside them that no bur has
/// removed. When these nodes are removed (nodesToRemove), the debris is gone too. `surface` belongs to the present
/// state of `bricks`.
[[nodiscard]] NodeSets nodesBesideDebris(const Surface& surface, const BrickMap& bricks, const Lattice& lattice);

}  // namespace tactooth
