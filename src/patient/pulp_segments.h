// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "geometry/util/vec.h"

namespace tactooth {

/// A part of the pulp: a cone with round ends.
struct PulpSegment {
    Vec3 a, b;                ///< mm
    double radiusA, radiusB;  ///< mm
};

/// Depth of a point below the surface of the tooth, mm; negative outside.
using DepthField = std::function<double(const Vec3&)>;

/// The segments of the pulp of a tooth with its crown up and its neck at z = 0, within `box`: a chamber, and a canal in
/// each root, through the deepest points of the sections. Empty if `progress` returns false (see LayerModel), or if the
/// tooth is too thin everywhere.
[[nodiscard]] std::vector<PulpSegment> pulpSegments(const DepthField& depth, const Box3& box,
                                                    const std::function<bool(double)>& progress);

}  // namespace tactooth
