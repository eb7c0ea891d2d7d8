// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tooth/volume/cut_volume.h"

namespace tactooth {

/// One layer of a tooth, or the whole tooth, without what burs have removed.
struct RemainingLayer {
    std::string name;   ///< name of the layer, or of the tooth's own material for a tooth without layers
    TriangleMesh mesh;  ///< closed; empty if nothing is left
};

/// The names in the result of remainingLayers. Known before anything is cut.
[[nodiscard]] std::vector<std::string> remainingLayerNames(const LayeredTooth& tooth);

/// Returns what is left of each layer of the tooth of `volume`. Where no bur has been, the triangles are those of the
/// layer, bit for bit. The walls are the same as those of the whole tooth. Each layer is taken as it was given, also
/// where a later one lies within it.
[[nodiscard]] std::vector<RemainingLayer> remainingLayers(const CutVolume& volume);

}  // namespace tactooth
