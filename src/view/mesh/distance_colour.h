// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "collision/solid/distance_grid.h"

namespace tactooth {

/// Which colours belong to which distances, mm: those of `distanceColour` from -range to range.
struct DistanceScale {
    double range = 1;
    /// Less than `range`. Up to it a distance has the colour of 0, and beyond it a colour that is easily distinguished
    /// from that; 0: there is no such band.
    double tolerance = 0;

    /// The place of a distance between the colours, -1..1.
    [[nodiscard]] double shareOf(double distance) const;
    bool operator==(const DistanceScale&) const = default;
};
inline constexpr double kToleranceStep = 0.3;  ///< the share just beyond the tolerance

/// Colours a surface by its distance to another one.
struct DistanceColourMap {
    std::shared_ptr<const DistanceGrid> grid;  ///< frame of the coloured object
    DistanceScale scale;

    bool operator==(const DistanceColourMap&) const = default;
};

/// The colour (sRGB) for `share` = distance / range in -1..1. Orange: the surface is inside the target (cut too deep).
/// White: both agree. Blue: the surface is outside (still to cut). Lightness differs between the middle and both ends;
/// blue against yellow separates the ends. All common kinds of colour blindness see both.
[[nodiscard]] Vec3f distanceColour(double share);

}  // namespace tactooth
