// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tooth/surface/triangle_clip.h"
#include "tooth/volume/cut_volume.h"

namespace tactooth {

/// What becomes of one triangle of the tooth's own surface.
struct ClippedBaseTriangle {
    bool hidden = false;                       ///< it is not drawn as it was
    bool failed = false;                       ///< its cut lines did not fit together; it is kept or dropped whole
    std::vector<std::array<Vec3f, 3>> pieces;  ///< what is left of it if a cut line crosses it
};

/// Decides for each of `triangles` (ascending numbers) what a cut leaves of it. `segments[i]` are the cut lines in
/// triangle i of the list; every triangle that a line crosses must be in the list.
[[nodiscard]] std::vector<ClippedBaseTriangle> clipBase(const CutVolume& volume,
                                                        const std::vector<std::uint32_t>& triangles,
                                                        const std::vector<std::vector<ClipSegment>>& segments);

}  // namespace tactooth
