// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>
#include <map>

#include "geometry/util/assert.h"
#include "tooth/volume/brick.h"
#include "tooth/volume/brick_key.h"

namespace tactooth {

/// A set of nodes of one brick, by nodeIndex.
using NodeSet = std::bitset<kBrickNodes>;
/// Node sets of several bricks.
using NodeSets = std::map<BrickKey, NodeSet>;

/// One of the six faces of a brick.
struct BrickFace {
    int axis;
    bool isUpper;

    [[nodiscard]] BrickKey beyond(const BrickKey& key) const {
        TACTOOTH_ASSERT(axis >= 0 && axis < 3);
        const int step = isUpper ? 1 : -1;
        return key.moved(axis == 0 ? step : 0, axis == 1 ? step : 0, axis == 2 ? step : 0);
    }
    [[nodiscard]] BrickFace opposite() const { return {axis, !isUpper}; }
    /// The nodes on this face.
    [[nodiscard]] const NodeSet& nodes() const;
    /// The nodes of the neighbour that are next to `own`. All of `own` are on this face.
    [[nodiscard]] NodeSet across(const NodeSet& own) const;
};
inline constexpr BrickFace kBrickFaces[] = {{0, false}, {0, true}, {1, false}, {1, true}, {2, false}, {2, true}};

/// The nodes of a brick that are tooth and not removed.
[[nodiscard]] NodeSet solidNodes(const Brick& brick);

/// The connected component of the first node of `all`. Nodes are connected along the axes.
[[nodiscard]] NodeSet firstComponent(const NodeSet& all);

/// Dilation: adds all nodes one step away, diagonals included, in the bricks of `sets`. Bricks that are not in `sets`
/// count as empty.
[[nodiscard]] NodeSets dilated(const NodeSets& sets);

}  // namespace tactooth
