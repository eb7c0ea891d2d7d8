// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/narrow/simd8.h"
#include "geometry/util/vec.h"

namespace tactooth {

/// The quadratic error function (QEF) of dual contouring: the planes in which the boundary crosses the edges of a cell,
/// and the vertex that they define. Works on eight cells side by side in single precision. Positions count in steps of
/// the lattice from the middle of each cell, so that the vertex is exact to 1e-7 of a step. Equal planes in equal order
/// give equal bits.
class CellQef8 {
public:
    /// Adds one plane to each cell, by its unit normal and a point on it. `counts` is 1, or 0 for a cell that gets no
    /// plane.
    void add(const Vec3x8& normal, const Vec3x8& point, Float8 counts);

    /// Means of the crossing points.
    [[nodiscard]] Vec3x8 means() const { return {points_.x / count_, points_.y / count_, points_.z / count_}; }

    /// `isFlat` is 1 for cells whose normals agree so well that the mean normal alone counts, else 0. `points` are on
    /// the mean normal through the means. With them for vertices, a bent boundary encloses the right volume.
    struct Flat {
        Float8 isFlat;
        Vec3x8 points;
    };
    [[nodiscard]] Flat flat() const;

    /// The point within `bounds` that is nearest to all planes of one cell and then to their mean, in the frame and
    /// unit of the planes. Directions without an edge do not count. If the planes meet outside the bounds, the point
    /// slides along a face of the bounds, so that a sharp edge that leaves them stays sharp.
    [[nodiscard]] Vec3f nearestPoint(int lane, const Box3& bounds) const;

private:
    [[nodiscard]] Vec3x8 timesProducts(const Vec3x8& vectors) const;

    Float8 count_ = Float8::all(0);
    Vec3x8 points_ = Vec3x8::all(0, 0, 0);     // sum of the points
    Vec3x8 normals_ = Vec3x8::all(0, 0, 0);    // sum of the normals
    Vec3x8 offsets_ = Vec3x8::all(0, 0, 0);    // sum of the normals times the heights of the points along them
    Vec3x8 productsX_ = Vec3x8::all(0, 0, 0);  // sums of the products xx, xy, xz of the normals' components
    Float8 yy_ = Float8::all(0);
    Float8 yz_ = Float8::all(0);
};

}  // namespace tactooth
