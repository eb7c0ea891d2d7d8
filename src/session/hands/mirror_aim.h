// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "collision/bvh/surface.h"
#include "geometry/util/pose.h"

namespace tactooth {

/// What a mirror shall show, and to whom. Tooth frame, mm.
struct MirrorAim {
    Vec3 tip;           ///< of the bur
    Vec3 shaft;         ///< unit, from the tip along the bur
    Vec3 eye;           ///< of the user
    Vec3 handle;        ///< unit, where the mirror's handle shall leave, as nearly as it can
    double radius = 0;  ///< of the glass
};

/// A pose of the mirror in which `aim.eye` sees the head of the bur from behind: from the side that the eye does not
/// see directly. Neither glass nor stem goes through `mouth`, and nothing of it stands in the line of sight. None if no
/// such place is found. Takes some ten milliseconds.
[[nodiscard]] std::optional<Pose> mirrorPoseBehind(const MirrorAim& aim, const Surface& mouth);

/// The same for the chewing surface or the edge of a tooth: for a bur that stood upright on the middle of its crown.
/// `tooth`: its box; `aim` needs no tip and no shaft.
[[nodiscard]] std::optional<Pose> mirrorPoseOverCrown(MirrorAim aim, const Box3& tooth, const Surface& mouth);

/// The share of the bur's head that `aim.eye` sees by a mirror at `mirror`, 0 .. 1.
[[nodiscard]] double seenByMirror(const MirrorAim& aim, const Pose& mirror, const Surface& mouth);

}  // namespace tactooth
