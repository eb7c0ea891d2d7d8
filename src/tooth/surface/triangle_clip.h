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

/// An end of a cut line's segment in a triangle: on the triangle's outline, or inside it where the next segment starts.
struct ClipPoint {
    Vec3 position;
    int edge = -1;                       ///< edge of the triangle, from corner `edge` to the next; -1 = inside
    double along = 0;                    ///< on an edge: position from its canonical first end, 0..1
    std::uint64_t crossingFace = 0;      ///< on an edge: number of the face that passes through it, to break ties
    std::array<std::uint64_t, 2> key{};  ///< inside: what the two segments that meet there share
};

/// A segment of a cut line. The part of the triangle to keep is on its left.
struct ClipSegment {
    ClipPoint start;
    ClipPoint end;
};

struct ClippedTriangle {
    std::vector<Vec3> points;  ///< the three corners of the whole triangle, then the points of the cut lines
    std::vector<Triangle> triangles;
};

/// Clips a triangle along lines that run from edge to edge or that are closed inside it. `isForward[i]`: edge i runs
/// from its canonical first end to its second. `keepsCorner`: whether each corner is kept where the lines do not decide
/// it. Returns nothing if the lines are inconsistent.
[[nodiscard]] std::optional<ClippedTriangle> clipTriangle(const std::array<Vec3, 3>& corners,
                                                          const std::array<bool, 3>& isForward,
                                                          const std::vector<ClipSegment>& segments,
                                                          const std::array<bool, 3>& keepsCorner);

/// A crossing of a cut line with an edge, in the canonical direction of the edge: it leaves the kept part or enters it.
struct EdgeCrossing {
    double along;
    std::uint64_t crossingFace;
    bool leaves;  ///< in canonical direction
    std::uint32_t segment;

    [[nodiscard]] bool liesBefore(const EdgeCrossing& other) const {
        return along != other.along ? along < other.along : crossingFace < other.crossingFace;
    }
};
/// Number of crossings that leave the kept part minus those that enter it. With 1 or -1 the crossings can alternate and
/// decide both ends. With 0 they can alternate, and both ends are kept or neither is.
[[nodiscard]] int exitSurplus(std::span<const EdgeCrossing> crossings);
/// Sorts the crossings of one edge so that they alternate, as close as possible to their order on the edge. Rounding
/// may swap near neighbours, and so may a folded wall. `firstKept`: whether the canonical first end is kept, where the
/// crossings do not decide it. False if the crossings cannot alternate.
[[nodiscard]] bool sortCrossings(std::span<EdgeCrossing> crossings, bool firstKept);

}  // namespace tactooth
