// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/bvh/surface.h"
#include "tooth/volume/brick_map.h"
#include "tooth/volume/lattice.h"
#include "tooth/volume/node_set.h"

namespace tactooth {

/// Finds debris: components of the surface that hold no node of the lattice. They are flakes thinner than a voxel, left
/// where a cut leaves the tooth through its own surface. Returns the nodes beside them that are in the air and not
/// removed. Removing these nodes (nodesToRemove) removes the debris. `surface` belongs to the present state of
/// `bricks`.
[[nodiscard]] NodeSets nodesBesideDebris(const Surface& surface, const BrickMap& bricks, const Lattice& lattice);

}  // namespace tactooth
