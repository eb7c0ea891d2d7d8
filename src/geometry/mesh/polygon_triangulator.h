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

/// Splits faces of more than three corners into triangles that cover exactly the face, whatever its shape and its first
/// corner. One object splits many faces and keeps its memory.
class PolygonTriangulator {
public:
    /// Adds the triangles of the face with `corners` (numbers of `positions`, where equal positions have the same
    /// number; four or more). If the fan from the first corner covers the face, as for each convex face, the result is
    /// this fan. A face may be out of plane as long as its projection along one axis does not cross itself. All corners
    /// remain corners of triangles, except for duplicates and spikes.
    ///
    /// Returns null or the problem: the outline crosses itself, or has too many corners. Then nothing is added.
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
