// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/io/import_note.h"
#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// What is known of how a tooth stands, beside its surface. Directions in the frame of the surface.
struct FrameHints {
    std::optional<Vec3> crown;   ///< toward the crown (from the dentin's middle to the enamel's)
    std::optional<Vec3> buccal;  ///< toward the cheek or lip, about
    bool isFlipped = false;      ///< the person says that the guess has the crown down
    double turn = 0;             ///< rad, about the tooth's long axis: what the person adds
};

struct FrameGuess {
    Pose toothInFile;  ///< where the tooth frame (+z crown, +y cheek, origin at the neck) stands in the surface's, mm
    std::vector<ImportNote> why;
};

/// Finds the tooth frame of a closed surface in mm. The long axis is that of the largest moment of area; the crown is
/// at the end that `hints` names, else at the thicker one. A surface that stands within 30 degrees of crown up keeps
/// its axes. Which side is the cheek's cannot be seen from one surface: it is taken from `hints`, else +y of the file,
/// the shortest way.
[[nodiscard]] FrameGuess guessToothFrame(const TriangleMesh& outer, const FrameHints& hints = {});

}  // namespace tactooth
