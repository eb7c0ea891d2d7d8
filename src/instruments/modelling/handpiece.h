// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>

#include "geometry/field/isosurface.h"
#include "instruments/modelling/blend.h"
#include "instruments/modelling/section_loft.h"

namespace tactooth {

/// The shape that handpieces share, in the tool frame, mm: a head around the axis of the bur, and a handle that leaves
/// it along +x with a fillet.
struct HandpieceForm {
    std::span<const Section> head = {};
    double headBottom = 9.0, headTop = 0;  ///< z of the ends of the head
    double headEdge = 0;                   ///< rounding of its upper edge
    std::span<const Section> handle = {};  ///< along x; their first axis is z
    double handleEnd = 0;                  ///< x of the end of the handle
    double handleEdge = 0;                 ///< rounding of its end
    double fillet = 0;
    double filletFrom = 0, filletTo = 0;  ///< z between which the fillet fades out upward, below the head's groove
    double halfWidth = 0, top = 0;        ///< bounds: largest |y|, and z of the highest point
    double cellSize = 0.3;                ///< of the isosurface: shows the grooves of the handle
};

/// A handpiece as an implicit function: about the distance to its surface in mm, negative inside.
class Handpiece {
public:
    explicit Handpiece(const HandpieceForm& form) : form_(form), head_(form.head), handle_(form.handle) {}

    /// `carved`: depth of the grooves in the handle here, mm.
    [[nodiscard]] double operator()(const Vec3& p, double carved) const {
        constexpr double kBottomEdge = 0.3, kMinFillet = 0.05;
        const double around = smoothIntersection(head_(p), form_.headBottom - p.z(), kBottomEdge);
        const double head = smoothIntersection(around, p.z() - form_.headTop, form_.headEdge);
        const double sheath = handle_(Vec3(p.z(), p.y(), p.x())) + carved;
        const double handle = smoothIntersection(std::max(sheath, -p.x()), p.x() - form_.handleEnd, form_.handleEdge);
        const double fillet = form_.fillet * smoothStep(form_.filletTo, form_.filletFrom, p.z()) + kMinFillet;
        return smoothUnion(head, handle, fillet);
    }

    /// z of the middle of the handle at x.
    [[nodiscard]] double handleMiddle(double x) const { return handle_.at(x).x; }

private:
    HandpieceForm form_;
    SectionLoft head_, handle_;
};

/// Grooves along a round handle, for the fingers.
struct Flutes {
    double from, to;  ///< x of their ends, mm
    double depth;     ///< mm
    int count;        ///< around the handle
};
/// Depth of the flutes at `p`, mm. `middle`: z of the middle of the handle there.
[[nodiscard]] double fluteDepth(const Flutes& flutes, const Vec3& p, double middle);

/// The closed surface of a handpiece of this form, with about `triangles` triangles. `solid` is its implicit function.
[[nodiscard]] TriangleMesh handpieceMesh(const HandpieceForm& form, const ScalarField& solid, int triangles);

}  // namespace tactooth
