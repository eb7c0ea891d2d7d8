// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh/ear_clipper.h"
#include "geometry/mesh/projected_polygon.h"
#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/message.h"

namespace tactooth {

/// Splits faces of more than three corners into triangles that cover the face and nothing beside it, whatever its shape
/// and the corner that it begins with. One splitter serves face after face and keeps its memory.
class PolygonTriangulator {
public:
    /// Adds the triangles of the face with `corners` (numbers of `positions`, where equal positions have the same
    /// number; four or more). A face that the fan from its first corner covers, as that of a convex one does, gets this
    /// fan. The face may be out of plane as far as seen along one axis it does not cross itself. All its corners stay
    /// corners of triangles, but for doubled ones and those of spikes.
    ///
    /// Null, or what is wrong: the outline crosses itself, or has too many corners. Then nothing is added.
    [[nodiscard]] const MessageText* split(std::span<const Vec3f> positions, std::span<const std::uint32_t> corners,
                                           std::vector<Triangle>& triangles);

private:
    [[nodiscard]] const MessageText* triangulateAnyShape(std::span<const Vec3f> positions, const Vec3& normal,
                                                         std::vector<Triangle>& triangles);
    void takeDistinct(std::span<const std::uint32_t> corners);

    std::vector<std::uint32_t> distinct_;
    ProjectedPolygon outline_;
    EarClipper clipper_;
};

}  // namespace tactooth
