// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "geometry/util/vec.h"

namespace tactooth {

/// A triangle of one of the two surfaces that meet at a cavity margin. The ids name its corners in all triangles.
struct IntersectingFace {
    std::array<Vec3f, 3> corner;  ///< counter-clockwise seen from outside the solid
    std::array<std::uint64_t, 3> id;
};

/// A point where an edge of one surface passes through a face of the other.
struct IntersectionPoint {
    Vec3 position;
    bool onBaseEdge;                      ///< the edge belongs to the base face, not to the wall face
    int edge;                             ///< edge of its face, from corner `edge` to the next
    double along;                         ///< 0..1, from the end of the edge with the lower id
    std::array<std::uint64_t, 2> edgeId;  ///< ids of the ends of the edge, lower first
};

/// The intersection of a base face and a wall face. On the base face, from `start` to `end`, the kept part (behind the
/// wall face) is on the left. On the wall face the kept part (behind the base face) is on the left from `end` to
/// `start`.
struct FaceIntersection {
    IntersectionPoint start;
    IntersectionPoint end;
};

/// Intersects a face of the tooth's own surface (`base`) with a face of a cavity wall. The result is always decided,
/// and all faces at an edge get the same decision: signs are exact, and where a corner lies exactly on the other
/// surface, the wall counts as moved by an infinitesimal (e, e^2, e^3).
[[nodiscard]] std::optional<FaceIntersection> intersectionOf(const IntersectingFace& base,
                                                             const IntersectingFace& wall);

}  // namespace tactooth
