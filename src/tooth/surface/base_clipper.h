// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tooth/surface/triangle_clip.h"
#include "tooth/volume/cut_volume.h"

namespace tactooth {

/// What a cut leaves of one triangle of the tooth's own surface.
struct ClippedBaseTriangle {
    bool hidden = false;                       ///< the original triangle is not visible any more
    bool failed = false;                       ///< its cut lines are inconsistent; it is kept or dropped whole
    std::vector<std::array<Vec3f, 3>> pieces;  ///< what is left of it if a cut line crosses it
};

/// Decides what a cut leaves of each of `triangles` (ascending numbers). `segments[i]` are the cut lines in triangle i
/// of the list. The list holds every triangle that a cut line crosses.
[[nodiscard]] std::vector<ClippedBaseTriangle> clipBase(const CutVolume& volume,
                                                        const std::vector<std::uint32_t>& triangles,
                                                        const std::vector<std::vector<ClipSegment>>& segments);

}  // namespace tactooth
