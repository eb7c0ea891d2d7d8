// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/modelling/handpiece.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh/simplify.h"
#include "geometry/util/assert.h"

namespace tactooth {

double fluteDepth(const Flutes& flutes, const Vec3& p, double middle) {
    constexpr double kFade = 1.5;  // mm along the handle, at both ends
    const double angle = std::atan2(p.y(), p.z() - middle);
    const double wave = std::max(0.0, std::cos(flutes.count * angle));
    return flutes.depth * wave * smoothStep(flutes.from - kFade, flutes.from, p.x()) *
           smoothStep(flutes.to + kFade, flutes.to, p.x());
}

TriangleMesh handpieceMesh(const HandpieceForm& form, const ScalarField& solid, int triangles) {
    TACTOOTH_ASSERT(triangles > 0);
    TACTOOTH_ASSERT(form.headTop > form.headBottom && form.handleEnd > 0);
    constexpr double kHeadRadius = 6.5, kMargin = 1;  // mm
    const Box3 bounds(Vec3(-kHeadRadius, -form.halfWidth, form.headBottom - kMargin),
                      Vec3(form.handleEnd + kMargin, form.halfWidth, form.top));
    const TriangleMesh fine = isosurface(solid, bounds, {.cellSize = form.cellSize});
    return simplified(fine, static_cast<std::size_t>(triangles));
}

}  // namespace tactooth
