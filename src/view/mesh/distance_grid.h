// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "collision/bvh/surface.h"

namespace tactooth {

/// Signed distances to a surface on a regular grid, mm, negative inside; x runs fastest. The first sample is at `low`.
struct DistanceGrid {
    Vec3 low = Vec3::Zero();
    double spacing = 1;  ///< mm
    Eigen::Array3i counts = Eigen::Array3i::Zero();
    std::vector<float> values;
};

/// Samples the distance to the closed surface `target` all over `box`, `longest` samples along its longest side. The
/// same on any number of threads.
[[nodiscard]] DistanceGrid sampleDistances(const SurfacePart& target, const Box3& box, int longest = 96);

/// Colours a surface by its distance to another one: `distanceColour` from -range to range.
struct DistanceColourMap {
    std::shared_ptr<const DistanceGrid> grid;  ///< frame of the object that is coloured
    double range = 1;                          ///< mm

    bool operator==(const DistanceColourMap&) const = default;
};

/// The colour (sRGB) for `share` = distance / range in -1..1: orange where the surface lies inside the target (too much
/// was taken), white where it agrees, blue where it lies outside (still to be taken). Differs in lightness from the
/// middle to both ends and in blue against yellow between them, which all common kinds of colour blindness see.
[[nodiscard]] Vec3f distanceColour(double share);

}  // namespace tactooth
