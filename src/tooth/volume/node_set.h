// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>
#include <map>

#include "geometry/util/assert.h"
#include "tooth/volume/brick.h"
#include "tooth/volume/brick_key.h"

namespace tactooth {

/// Some nodes of one brick, by nodeIndex.
using NodeSet = std::bitset<kBrickNodes>;
/// Some nodes of some bricks.
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
    /// Those of the neighbour that stand beside `own`, which are on this face.
    [[nodiscard]] NodeSet across(const NodeSet& own) const;
};
inline constexpr BrickFace kBrickFaces[] = {{0, false}, {0, true}, {1, false}, {1, true}, {2, false}, {2, true}};

/// The nodes of a brick that are tooth and not removed.
[[nodiscard]] NodeSet solidNodes(const Brick& brick);

/// What hangs together with the first node of `all`, node beside node along the axes.
[[nodiscard]] NodeSet firstComponent(const NodeSet& all);

/// With all nodes one step away, diagonals too, in the bricks that `sets` names; neighbours that it does not name are
/// empty.
[[nodiscard]] NodeSets dilated(const NodeSets& sets);

}  // namespace tactooth
