// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "collision/bvh/surface.h"
#include "geometry/util/pose.h"
#include "session/hands/instrument_poses.h"

namespace tactooth {

/// What may stand between the eye and the tip of the bur.
struct Obstacles {
    const Surface& tooth;
    const Surface* handpiece = nullptr;  ///< tool frame; null: it is not shown
};

/// The share (0..1) of the surface up to 1 mm around the tip of a tool that an eye in the direction `toEye` (unit,
/// tooth frame) sees past the tooth and the handpiece. Where there is no surface below, the place level with the tip
/// counts.
[[nodiscard]] double seenShare(const Obstacles& obstacles, const Pose& tool, const Vec3& toEye);

/// The direction nearest to `usual` from which the tips of all `tools` are seen, each at 90 % at least. The one that
/// shows most of them if there is none.
[[nodiscard]] ViewDirection clearView(const Obstacles& obstacles, std::span<const Pose> tools, ViewDirection usual);

}  // namespace tactooth
