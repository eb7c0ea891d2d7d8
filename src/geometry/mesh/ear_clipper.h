// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/projected_polygon.h"
#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Cuts an outline into triangles by ear clipping (G. Meisters, "Polygons Have Ears", 1975), with exact signs. The
/// outline may touch itself, as one does that reaches a hole over a bridge of two edges on each other. Where it can,
/// it makes no triangle that is all but flat of corners on one line.
class EarClipper {
public:
    enum class Result { Done, NoEar, LimitReached };

    /// Adds the triangles, in vertex numbers of the outline; all look to its viewer and together cover it once, if no
    /// two of its edges cross. Without an ear, or after `maxTests` tests of a corner against a triangle, those that
    /// were found are added nevertheless: the caller takes them back.
    [[nodiscard]] Result clip(const ProjectedPolygon& outline, std::size_t maxTests, std::vector<Triangle>& triangles);

private:
    using Corner = std::uint32_t;
    enum class EarPolicy { NoFlatEar, AnyEar };

    void begin(const ProjectedPolygon& outline, std::size_t maxTests);
    [[nodiscard]] bool findEar(Corner& from, EarPolicy policy);
    [[nodiscard]] bool isEar(Corner ear, EarPolicy policy);
    [[nodiscard]] bool blocks(Corner corner, Corner a, Corner b, Corner c, EarPolicy policy) const;
    [[nodiscard]] bool isWithinCorners(Corner a, Corner c, Corner b) const;
    [[nodiscard]] bool turnsClearly(Corner corner) const;
    void remove(Corner corner);
    Corner removeSpikes(Corner corner);
    void forgetBlockers();

    const ProjectedPolygon* outline_ = nullptr;
    std::vector<Corner> next_, previous_;
    std::vector<bool> mayBlock_;    ///< corners that turn right or hardly at all: only they can lie in an ear
    std::vector<Corner> blockers_;  ///< in the order of x; some have become others meanwhile
    std::size_t liveBlockers_ = 0;
    std::size_t left_ = 0;  ///< corners of the outline that is left
    std::size_t tests_ = 0, maxTests_ = 0;
};

}  // namespace tactooth
