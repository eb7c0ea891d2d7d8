// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tooth/model/layered_tooth.h"
#include "tooth/volume/brick_map.h"
#include "tooth/volume/node_set.h"

namespace tactooth {

/// A piece that burs have cut off all around: no path along lattice edges leads to the rest of its body.
struct DetachedPiece {
    NodeSets nodes;                   ///< in sampled bricks
    std::vector<BrickKey> unsampled;  ///< unsampled bricks that may hold more of it; no bur came near
};

/// Limit of the unsampled bricks in a detached piece. A larger piece (32 mm^3 at 25 um, 260 at 50 um) stays in place,
/// as the rest of the tooth does: its removal would have to make all of its bricks.
inline constexpr std::size_t kMaxUnsampled = 4000;

/// Finds the detached pieces. Looks at all sampled bricks. The largest piece of each body of the uncut outer surface
/// never counts as detached.
[[nodiscard]] std::vector<DetachedPiece> findDetachedPieces(const BrickMap& bricks, const LayeredTooth& tooth,
                                                            const Lattice& lattice);

}  // namespace tactooth
