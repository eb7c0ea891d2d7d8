// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "collision/bvh/surface.h"

namespace tactooth {

/// A signed distance and the direction in which it grows.
struct GridSample {
    double distance;  ///< mm
    Vec3 gradient;    ///< mm per mm: about unit near a smooth surface, shorter at its edges
};

/// Signed distances to a surface on a regular grid, mm, negative inside. x varies fastest. The first sample is at
/// `low`.
struct DistanceGrid {
    Vec3 low = Vec3::Zero();
    double spacing = 1;  ///< mm
    Eigen::Array3i counts = Eigen::Array3i::Zero();
    std::vector<float> values;

    /// Between the samples, linear along each axis. Nothing outside of the grid. Neither allocates nor fails.
    [[nodiscard]] std::optional<GridSample> at(const Vec3& place) const;
};

/// Samples the distance to the closed surface `target` everywhere in `box`, with `longest` samples along its longest
/// side. The result is the same for any number of threads.
[[nodiscard]] DistanceGrid sampleDistances(const SurfacePart& target, const Box3& box, int longest = 96);

}  // namespace tactooth
