// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tooth/volume/brick_map.h"
#include "tooth/volume/material_volumes.h"
#include "tooth/volume/node_set.h"

namespace tactooth {

/// The nodes that have to go so that nothing is left of pieces with these nodes (solid ones, and some beside them in
/// the air): they themselves, and around them, where a piece may run out into an edge too thin to hold nodes, what is
/// in the air or removed already; nothing in the air that is beside a node that stays. The bricks of the pieces and all
/// around them exist unless they are clear of the tooth.
[[nodiscard]] NodeSets nodesToRemove(const BrickMap& bricks, const NodeSets& pieces);

/// Removes nodes of one brick as if a bur had been deep around each. Returns what that takes from the tooth.
MaterialVolumes removeNodes(Brick& brick, const NodeSet& nodes, double spacing);

/// Puts the border of the removed region on the lattice edges of one brick that lead from a node of `gone` to one that
/// is not removed: right before that, since what is gone reaches no farther than the tooth's surface.
void placeBoundary(BrickMap& bricks, const BrickKey& key, const NodeSets& gone);

}  // namespace tactooth
