// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/isosurface.h"

namespace tactooth {

/// The surface that `isosurface` makes, and where its vertices stood in the cells of the grid before they were evened
/// out: less smooth there, but the two sides of a thin place lie apart.
struct EvenedSurface {
    TriangleMesh mesh;
    std::vector<Vec3f> home;
};
[[nodiscard]] EvenedSurface evenedSurface(const ScalarField& field, const Box3& box, const IsosurfaceOptions& options);

}  // namespace tactooth
