// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>

#include "instruments/modelling/blend.h"
#include "instruments/modelling/section_loft.h"

namespace tactooth {

/// The shape that handpieces share, in the tool frame, mm: a head around the bur's axis and a handle that leaves it
/// along +x and is filleted into it.
struct HandpieceForm {
    std::span<const Section> head = {};
    double headBottom = 0, headTop = 0;    ///< z where the head is cut off
    double headEdge = 0;                   ///< rounding of its upper edge
    std::span<const Section> handle = {};  ///< along x; their first axis is z
    double handleEnd = 0;                  ///< x where the handle is cut off
    double handleEdge = 0;                 ///< rounding of its end
    double fillet = 0;
    double filletFrom = 0, filletTo = 0;  ///< z between which the fillet runs out upward, below the head's groove
};

/// A handpiece as a solid: about the distance to its surface, negative inside.
class Handpiece {
public:
    explicit Handpiece(const HandpieceForm& form) : form_(form), head_(form.head), handle_(form.handle) {}

    /// `carved`: how deep the handle's surface lies here below its sections.
    [[nodiscard]] double operator()(const Vec3& p, double carved) const {
        constexpr double kBottomEdge = 0.3, kMinFillet = 0.05;
        const double around = smoothIntersection(head_(p), form_.headBottom - p.z(), kBottomEdge);
        const double head = smoothIntersection(around, p.z() - form_.headTop, form_.headEdge);
        const double sheath = handle_(Vec3(p.z(), p.y(), p.x())) + carved;
        const double handle = smoothIntersection(std::max(sheath, -p.x()), p.x() - form_.handleEnd, form_.handleEdge);
        const double fillet = form_.fillet * smoothStep(form_.filletTo, form_.filletFrom, p.z()) + kMinFillet;
        return smoothUnion(head, handle, fillet);
    }

    /// z of the handle's middle at x.
    [[nodiscard]] double handleMiddle(double x) const { return handle_.at(x).x; }

private:
    HandpieceForm form_;
    SectionLoft head_, handle_;
};

}  // namespace tactooth
