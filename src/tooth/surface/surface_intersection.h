// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "geometry/util/vec.h"

namespace tactooth {

/// A triangle of one of the two surfaces that meet at a cavity's margin, with numbers that name its corners wherever
/// else they occur.
struct IntersectingFace {
    std::array<Vec3f, 3> corner;  ///< counter-clockwise seen from outside the solid
    std::array<std::uint64_t, 3> id;
};

/// A point in which an edge of one surface runs through a face of the other.
struct IntersectionPoint {
    Vec3 position;
    bool onBaseEdge;                      ///< the edge belongs to the base face, else to the wall face
    int edge;                             ///< which edge of its face: from corner `edge` to the next
    double along;                         ///< 0..1 from the edge's end with the lower id
    std::array<std::uint64_t, 2> edgeId;  ///< ids of the edge's ends, lower first
};

/// Where a base face and a wall face cross. Walking from `start` to `end` on the base face, the part of it to keep
/// (behind the wall face) is on the left; on the wall face the part to keep (behind the base face) is on the left of
/// the way back.
struct FaceIntersection {
    IntersectionPoint start;
    IntersectionPoint end;
};

/// The crossing of a face of the tooth's own surface (`base`) with one of the cavity's wall. Always decided, and always
/// the same way for an edge whichever of its faces asks: signs are exact, and where a corner lies exactly on the other
/// surface the wall counts as moved by an infinitesimal (e, e^2, e^3).
[[nodiscard]] std::optional<FaceIntersection> intersectionOf(const IntersectingFace& base,
                                                             const IntersectingFace& wall);

}  // namespace tactooth
