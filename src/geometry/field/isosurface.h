// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A body given by a function: negative inside, positive outside, about the distance in mm near the surface. Called
/// from several threads at once.
using ScalarField = std::function<double(const Vec3&)>;

struct IsosurfaceOptions {
    double cellSize = 0.2;        ///< mm; triangles have about this edge length
    double lipschitzBound = 1.5;  ///< no two points differ in value by more than this times their distance
    int relaxations = 3;          ///< rounds that even out the triangles before the vertices go to the exact surface
};

/// The surface field = 0 within `box`: closed (where the body ends within the box), oriented, every edge with two
/// triangles, for any field. The grid stands at multiples of the cell size, so that two fields that agree
/// in a region give the same triangles there. The same arguments give the same bits on any number of threads.
[[nodiscard]] TriangleMesh isosurface(const ScalarField& field, const Box3& box, const IsosurfaceOptions& options);

/// The surface that `isosurface` makes, and where its vertices stood in the cells of the grid before they were evened
/// out: less smooth there, but the two sides of a thin place lie apart.
struct RelaxedSurface {
    TriangleMesh mesh;
    std::vector<Vec3f> restPositions;
};
[[nodiscard]] RelaxedSurface relaxedIsosurface(const ScalarField& field, const Box3& box,
                                               const IsosurfaceOptions& options);

}  // namespace tactooth
