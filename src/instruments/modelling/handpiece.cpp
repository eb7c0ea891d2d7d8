// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/modelling/handpiece.h"

#include "geometry/mesh/simplify.h"
#include "geometry/util/assert.h"

namespace tactooth {

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
