// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/projected_polygon.h"
#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Triangulates an outline by ear clipping (G. Meisters, "Polygons Have Ears", 1975), with exact signs. Ours differs in
/// two points. The outline may touch itself, as one with a hole that two coincident edges connect. Nearly flat
/// triangles are avoided where possible.
class EarClipper {
public:
    enum class Result { Done, NoEar, LimitReached };

    /// Adds the triangles, in vertex numbers of the outline. All face the viewer, and together they cover the outline
    /// once, if no two of its edges cross. If there is no ear, or after `maxTests` tests of a corner against a
    /// triangle, the triangles so far remain in `triangles`, and the caller removes them. The outline has three or more
    /// corners.
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
    std::vector<bool> mayBlock_;    ///< corners that turn right or hardly at all: only they can be inside an ear
    std::vector<Corner> blockers_;  ///< in the order of x; some may have become convex meanwhile
    std::size_t liveBlockers_ = 0;
    std::size_t left_ = 0;  ///< corners of the remaining outline
    std::size_t tests_ = 0, maxTests_ = 0;
};

}  // namespace tactooth
