// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/pose.h"

namespace tactooth {

/// Orientation of an upright tool: its handle (+x of the tool frame) leaves the mouth mesially, turned by
/// `towardLingual` rad to the side of the tongue. `mesialX`: direction of mesial along x.
[[nodiscard]] Quat uprightGrip(double mesialX, double towardLingual);

/// Pose of a mirror that shows the lingual side of a tooth's crown to an eye in the direction `toEye` (unit). The
/// mirror is behind the crown and level with it, a little to distal, where its handle leaves. `tooth`: the tooth's box;
/// `mesialX`: direction of mesial along x.
[[nodiscard]] Pose parkedMirror(const Box3& tooth, const Vec3& toEye, double mesialX);

/// Pose in which an assistant holds the suction tube: the opening is beside the crown, distal and buccal, clear of bur
/// and mirror.
[[nodiscard]] Pose parkedSuction(const Box3& tooth, double mesialX);

/// A direction of view: the eye's place on a sphere around the tooth, rad. Azimuth 0 looks from +x, 90 degrees from +y
/// (buccal); elevation 90 degrees looks from +z (occlusal).
struct ViewDirection {
    double azimuth = 0;
    double elevation = 0;
};

/// From buccal and above, as a dentist sees a lower tooth. `mesialX`: direction of mesial along x.
[[nodiscard]] ViewDirection dentistView(double mesialX);

/// From the tooth to the eye: unit, tooth frame.
[[nodiscard]] Vec3 directionToEye(const ViewDirection& view);

}  // namespace tactooth
