// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tooth/volume/brick_map.h"
#include "tooth/volume/material_volumes.h"
#include "tooth/volume/node_set.h"

namespace tactooth {

/// The nodes to remove so that nothing remains of some detached pieces. `pieces` holds the solid nodes of the pieces,
/// and nodes in the air beside them; it is not empty. A piece may end in an edge too thin to hold a node. So the result
/// is `pieces` and the nodes around them that are in the air or removed already, but no node in the air next to a solid
/// node that stays. The bricks of the pieces and their neighbours must be sampled.
[[nodiscard]] NodeSets nodesToRemove(const BrickMap& bricks, const NodeSets& pieces);

/// Removes nodes of one brick, as if a bur had removed everything around each of them. Returns the removed volumes,
/// mm^3. `nodes` is not empty; `spacing` in mm.
MaterialVolumes removeNodes(Brick& brick, const NodeSet& nodes, double spacing);

/// Sets the boundary on the lattice edges of one brick from a node of `gone` to a node that is not removed. It lies
/// just before that node, since the removed piece ends at the tooth's surface.
void placeBoundary(BrickMap& bricks, const BrickKey& key, const NodeSets& gone);

}  // namespace tactooth
