// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// An end of a cut line in a triangle: on its border, or inside it where the next piece of the line begins.
struct ClipPoint {
    Vec3 position;
    int edge = -1;                       ///< edge of the triangle, from corner `edge` to the next; -1 = inside
    double along = 0;                    ///< on an edge: place from its canonical first end, 0..1
    std::uint64_t crossingFace = 0;      ///< on an edge: number of the face that runs through it, to break ties
    std::array<std::uint64_t, 2> key{};  ///< inside: what the two pieces that meet there have in common
};

/// A piece of a cut line; the part of the triangle to keep is on its left.
struct ClipSegment {
    ClipPoint start;
    ClipPoint end;
};

struct ClippedTriangle {
    std::vector<Vec3> points;  ///< the three corners of the whole triangle, then the points of the cut lines
    std::vector<Triangle> triangles;
};

/// Cuts a triangle along lines that run from border to border or close within it, and keeps what is left of them.
/// `isForward[i]`: edge i runs from its canonical first end to its second. `keepsCorner`: what holds for each corner,
/// where the lines do not tell. Nothing if the lines do not fit together.
[[nodiscard]] std::optional<ClippedTriangle> clipTriangle(const std::array<Vec3, 3>& corners,
                                                          const std::array<bool, 3>& isForward,
                                                          const std::vector<ClipSegment>& segments,
                                                          const std::array<bool, 3>& keepsCorner);

/// Where a cut line crosses an edge, seen along the canonical direction: it either leaves the kept part or enters it.
struct EdgeCrossing {
    double along;
    std::uint64_t crossingFace;
    bool leaves;  ///< in canonical direction
    std::uint32_t segment;

    [[nodiscard]] bool liesBefore(const EdgeCrossing& other) const {
        return along != other.along ? along < other.along : crossingFace < other.crossingFace;
    }
};
/// How many more of the crossings of an edge leave the kept part than enter it. They can alternate if it is 1 or -1,
/// which tells what becomes of the ends, or 0: then both are kept or neither.
[[nodiscard]] int exitSurplus(std::span<const EdgeCrossing> crossings);
/// Brings the crossings of one edge into an order in which they alternate, as near as can be to that in which they lie
/// on it: rounding may swap near neighbours, and so does a wall that is folded there. `firstKept`: the canonical first
/// end, where the crossings do not tell. False if they cannot alternate.
[[nodiscard]] bool sortCrossings(std::span<EdgeCrossing> crossings, bool firstKept);

}  // namespace tactooth
