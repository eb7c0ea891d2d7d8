// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "tooth/model/layered_tooth.h"
#include "tooth/volume/brick.h"
#include "tooth/volume/lattice.h"

namespace tactooth {

/// Samples the uncut tooth at the nodes of one brick: exact distance to its surface (clamped to kToothBand), and
/// material. Null if every node is so far outside that no cut in the brick can reach the surface.
[[nodiscard]] std::unique_ptr<Brick> sampleBrick(const LayeredTooth& tooth, const Lattice& lattice,
                                                 const BrickKey& key);

}  // namespace tactooth
