// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A body given by an implicit function: negative inside, positive outside, about the distance in mm near the surface.
/// Called from several threads at once.
using ScalarField = std::function<double(const Vec3&)>;

/// Resolution and smoothness of an isosurface. All numbers are finite; cellSize and lipschitzBound are positive.
struct IsosurfaceOptions {
    double cellSize = 0.2;  ///< mm; triangles have about this edge length
    /// Lipschitz bound: two values differ by at most this times the distance of their points.
    double lipschitzBound = 1.5;
    int relaxations = 3;  ///< steps of relaxation before the vertices move onto the exact surface
};

/// The surface field = 0 within `box`: closed (where the body ends within the box), oriented, every edge with two
/// triangles, for any field. The grid is at multiples of the cell size, so that two fields that agree in a region give
/// the same triangles there. The same arguments give the same bits on any number of threads.
[[nodiscard]] TriangleMesh isosurface(const ScalarField& field, const Box3& box, const IsosurfaceOptions& options);

/// The surface of `isosurface`, and the positions of its vertices before relaxation. These are less smooth, but the two
/// sides of a thin place are separate.
struct RelaxedSurface {
    TriangleMesh mesh;
    std::vector<Vec3f> restPositions;
};
[[nodiscard]] RelaxedSurface relaxedIsosurface(const ScalarField& field, const Box3& box,
                                               const IsosurfaceOptions& options);

}  // namespace tactooth
