// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tooth/model/layered_tooth.h"
#include "tooth/volume/brick_map.h"
#include "tooth/volume/node_set.h"

namespace tactooth {

/// A piece that burs have cut off all around: no way along the lattice's edges leads from it to the rest of its body.
struct DetachedPiece {
    NodeSets nodes;  ///< in bricks that exist
    std::vector<BrickKey>
        unsampled;  ///< bricks that may hold more of it and have not been made, since no bur came near
};

/// Most bricks that no bur has come near in a loose piece; one with more (32 mm^3 at 25 um, 260 at 50 um) stays where
/// it is, as the rest of the tooth does: to remove it all of its bricks would have to be made.
inline constexpr std::size_t kMaxUnsampled = 4000;

/// Looks at all bricks that exist. Of each body that the tooth's outer surface had before anything was cut, the largest
/// piece is never loose.
[[nodiscard]] std::vector<DetachedPiece> findDetachedPieces(const BrickMap& bricks, const LayeredTooth& tooth,
                                                            const Lattice& lattice);

}  // namespace tactooth
