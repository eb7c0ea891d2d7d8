// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "collision/bvh/surface.h"

namespace tactooth {

/// Signed distances to a surface on a regular grid, mm, negative inside. x varies fastest. The first sample is at
/// `low`.
struct DistanceGrid {
    Vec3 low = Vec3::Zero();
    double spacing = 1;  ///< mm
    Eigen::Array3i counts = Eigen::Array3i::Zero();
    std::vector<float> values;
};

/// Samples the distance to the closed surface `target` everywhere in `box`, with `longest` samples along its longest
/// side. The result is the same for any number of threads.
[[nodiscard]] DistanceGrid sampleDistances(const SurfacePart& target, const Box3& box, int longest = 96);

/// Colours a surface by its distance to another one, with `distanceColour` from -range to range.
struct DistanceColourMap {
    std::shared_ptr<const DistanceGrid> grid;  ///< frame of the coloured object
    double range = 1;                          ///< mm

    bool operator==(const DistanceColourMap&) const = default;
};

/// The colour (sRGB) for `share` = distance / range in -1..1. Orange: the surface is inside the target (cut too deep).
/// White: both agree. Blue: the surface is outside (still to cut). Lightness differs between the middle and both ends;
/// blue against yellow separates the ends. All common kinds of colour blindness see both.
[[nodiscard]] Vec3f distanceColour(double share);

}  // namespace tactooth
