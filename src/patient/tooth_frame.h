// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/io/import_note.h"
#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Known facts about the pose of a tooth, beside its surface. Directions are in the frame of the surface.
struct FrameHints {
    std::optional<Vec3> crown;   ///< toward the crown (from the centre of the dentin to that of the enamel)
    std::optional<Vec3> buccal;  ///< approximately toward the cheek or lip
    bool isFlipped = false;      ///< the user says that the guess has the crown down
    double turn = 0;             ///< rad, about the long axis: rotation that the user adds
};

struct FrameGuess {
    Pose toothInFile;  ///< the tooth frame (+z crown, +y cheek, origin at the neck) in the frame of the surface, mm
    std::vector<ImportNote> why;
};

/// Finds the tooth frame of a closed surface in mm. The long axis is that of the largest moment of area; the crown is
/// at the end that `hints` names, else at the thicker one. A surface within 30 degrees of crown up keeps its axes. One
/// surface does not show the buccal side: it comes from `hints`, or is +y of the file by the shortest rotation.
[[nodiscard]] FrameGuess guessToothFrame(const TriangleMesh& outer, const FrameHints& hints = {});

/// The angle between +z of the file, where views and exercises expect the crown, and the crown of a tooth, rad. The
/// crown is taken to be the thicker end of the long axis. Nothing if the surface is about as long as wide, or as thick
/// at both ends. `outer` is closed and in mm.
[[nodiscard]] std::optional<double> crownTilt(const TriangleMesh& outer);

/// What a user should know who opens a tooth as it lies in its file; nothing if it stands crown up.
[[nodiscard]] std::optional<ImportNote> noteOnTilt(const TriangleMesh& outer);

}  // namespace tactooth
