// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tooth/volume/brick_map.h"
#include "tooth/volume/material_volumes.h"
#include "tooth/volume/node_set.h"

namespace tactooth {

/// The nodes to remove so that nothing remains of pieces with these nodes (solid ones, and some beside them in the
/// air). These are the nodes themselves and nodes around them that are in the air or removed already, since a piece may
/// end in an edge too thin to hold nodes. A node in the air next to a node that stays is not removed. The bricks of the
/// pieces and all around them were sampled. `pieces` is not empty.
[[nodiscard]] NodeSets nodesToRemove(const BrickMap& bricks, const NodeSets& pieces);

/// Removes nodes of one brick as if a bur had been deep around each. Returns the removed volumes, mm^3. `nodes` is not
/// empty.
MaterialVolumes removeNodes(Brick& brick, const NodeSet& nodes, double spacing);

/// Sets the boundary on the lattice edges of one brick from a node of `gone` to a node that is not removed. It lies
/// just before that node, since the removed piece ends at the tooth's surface.
void placeBoundary(BrickMap& bricks, const BrickKey& key, const NodeSets& gone);

}  // namespace tactooth
