// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/narrow/simd8.h"
#include "geometry/util/vec.h"

namespace tactooth {

/// The planes in which a border crosses the edges of a cell, and where they put the cell's vertex (the quadric of dual
/// contouring), for eight cells side by side and in single precision. Places count in steps of the lattice from the
/// middle of each cell, so that its vertex is true to a ten-millionth of a step. Equal planes in equal order give equal
/// bits.
class CellQef8 {
public:
    /// One plane to each cell, by its normal and a point on it; `counts`: 1, or 0 for a cell that gets none.
    void add(const Vec3x8& normal, const Vec3x8& point, Float8 counts);

    /// Of the points in which the edges are crossed.
    [[nodiscard]] Vec3x8 means() const { return {points_.x / count_, points_.y / count_, points_.z / count_}; }

    /// Cells whose normals agree so well that the mean one alone counts (1, else 0), and the points of their border
    /// along it from the means.
    struct Flat {
        Float8 isFlat;
        Vec3x8 points;
    };
    [[nodiscard]] Flat flat() const;

    /// The point of `room` nearest to all planes of one cell and then to their mean, directions without an edge left
    /// out. Where the planes meet outside, the point slides along the wall of the room: a sharp edge that leaves
    /// through it stays sharp.
    [[nodiscard]] Vec3f nearestPoint(int lane, const Box3& room) const;

private:
    [[nodiscard]] Vec3x8 timesProducts(const Vec3x8& vectors) const;

    Float8 count_ = Float8::all(0);
    Vec3x8 points_ = Vec3x8::all(0, 0, 0);     // their sum
    Vec3x8 normals_ = Vec3x8::all(0, 0, 0);    // their sum
    Vec3x8 offsets_ = Vec3x8::all(0, 0, 0);    // sum of the normals times the points' heights along them
    Vec3x8 productsX_ = Vec3x8::all(0, 0, 0);  // sums of the normals' products xx, xy, xz
    Float8 yy_ = Float8::all(0);
    Float8 yz_ = Float8::all(0);
};

}  // namespace tactooth
