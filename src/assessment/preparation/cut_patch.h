// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "assessment/preparation/preparation.h"

namespace tactooth {

/// Numbers of some triangles of CutSurfaces::cut, in rising order: a floor, or walls.
using CutPatch = std::vector<std::uint32_t>;

/// The connected pieces of `patch` by their corners, the largest area first.
[[nodiscard]] std::vector<CutPatch> connectedPieces(const CutSurfaces& surfaces, const CutPatch& patch);

/// What is left of `patch` without a strip of `width` mm along its border: the rounded angles to its neighbours.
[[nodiscard]] CutPatch withoutBorder(const CutSurfaces& surfaces, const CutPatch& patch, double width);

/// mm^2
[[nodiscard]] double areaOf(const CutSurfaces& surfaces, const CutPatch& patch);

/// The triangles whose normal has a cosine with the axis between the two.
[[nodiscard]] CutPatch patchBetween(const CutSurfaces& surfaces, const Vec3& axis, double low, double high);

/// The mean of a part of the facets of `patch` (their centres, or their normals), weighted by area, and the direction
/// in which it spreads least around that mean. `patch` is not empty.
struct LeastSpread {
    Vec3 mean, direction;  ///< `direction` is unit; its sense is arbitrary
    double rms;            ///< root mean square distance from the mean along `direction`
};
[[nodiscard]] LeastSpread leastSpread(const CutSurfaces& surfaces, const CutPatch& patch, Vec3 Facet::*part);

}  // namespace tactooth
