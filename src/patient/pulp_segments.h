// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "geometry/util/vec.h"

namespace tactooth {

/// A piece of the pulp: a cone with round ends.
struct PulpSegment {
    Vec3 a, b;                ///< mm
    double radiusA, radiusB;  ///< mm
};

/// How deep a point lies below the tooth's surface, mm; negative outside.
using DepthField = std::function<double(const Vec3&)>;

/// The pulp's limbs in a tooth that stands crown up with its neck at z = 0 within `box`: a chamber, and a canal down
/// each root, through the deepest places of the sections. Nothing if `progress` says stop (see LayerModel), or if the
/// tooth is too thin everywhere.
[[nodiscard]] std::vector<PulpSegment> pulpSegments(const DepthField& depth, const Box3& box,
                                                    const std::function<bool(double)>& progress);

}  // namespace tactooth
