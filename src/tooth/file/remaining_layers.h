// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tooth/volume/cut_volume.h"

namespace tactooth {

/// One layer of a tooth, or the whole tooth, without what burs have removed.
struct RemainingLayer {
    std::string name;   ///< of the layer; that of the tooth's own material for a tooth without layers
    TriangleMesh mesh;  ///< closed; empty if nothing is left
};

/// The names that remainingLayers gives, before anything is cut.
[[nodiscard]] std::vector<std::string> remainingLayerNames(const LayeredTooth& tooth);

/// What is left of each layer of the tooth of `volume`: its own triangles, bit for bit, wherever no bur has been, and
/// the same walls as those of the whole tooth. A layer is taken as it was given, also where a later one lies within it.
[[nodiscard]] std::vector<RemainingLayer> remainingLayers(const CutVolume& volume);

}  // namespace tactooth
