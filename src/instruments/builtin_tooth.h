// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "tooth/layered_tooth.h"

namespace tactooth {

enum class BuiltinToothKind { lowerFirstMolar, upperCentralIncisor, upperCanine };

/// A tooth made by the program itself. Tooth frame: origin in the tooth's axis at the height of the cervical line's
/// lowest (buccal and lingual) points, +z toward the crown, +x mesial, +y buccal; mm.
///
/// Layers nest and the inner one wins: enamel < dentin < pulp < caries. `enamel` is the whole crown as a closed body;
/// what lies within `dentin` is dentin, and so on. Enamel and dentin together fill `outer`; where they reach the
/// tooth's surface they share its vertices.
struct BuiltinTooth {
    std::string name;     ///< for people
    int fdi = 0;          ///< two-digit tooth number (FDI)
    TriangleMesh outer;   ///< the whole tooth, closed
    TriangleMesh enamel;  ///< the crown down to the cervical line, closed
    TriangleMesh dentin;  ///< crown core and root with its cementum, closed
    TriangleMesh pulp;    ///< chamber, horns and canals, closed, inside the dentin
    TriangleMesh caries;  ///< the lesion, closed; empty if there is none
};

/// Width of the built-in lesion where it spreads in the dentin, mm: a moderate cavity, short of the pulp.
inline constexpr double kDefaultLesionWidth = 2.4;

/// Makes a tooth whose `outer` has about `triangles` triangles; the other layers are as fine. `lesionWidth` (mm, 0 for
/// a sound tooth, at most 4): molar in the central fissure, incisor on the mesial contact, canine at the buccal neck.
/// The same arguments give the same bits, on any number of threads.
[[nodiscard]] BuiltinTooth makeBuiltinTooth(BuiltinToothKind kind, int triangles = 20000,
                                            double lesionWidth = kDefaultLesionWidth);

/// The layers as LayeredTooth::make takes them beside `outer`.
[[nodiscard]] std::vector<LayerMesh> layersOf(const BuiltinTooth& tooth);

}  // namespace tactooth
