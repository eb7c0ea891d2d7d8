// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Modelled after drawings of the manufacturers: head 9 mm wide and 14 mm high, 20 mm across the coupling.
#include "instruments/contra_angle.h"

#include "instruments/modelling/handpiece.h"

namespace tactooth {
namespace {

// The head around the axis of the bur: nose, barrel, cap with the latch on it.
constexpr double kHeadTop = 22.6;
constexpr Section kHead[] = {circle(9.0, 2.1),  circle(9.8, 2.2),   circle(10.0, 2.9), circle(10.6, 3.7),
                             circle(11.6, 4.2), circle(13.5, 4.45), circle(19.8, 4.5), circle(20.3, 4.35),
                             circle(20.6, 4.0), circle(21.0, 4.0),  circle(21.4, 4.3), circle(22.6, 4.0)};

// The handle along +x, as sections whose first axis is z: the neck rises by 20 degrees, the sheath is bent back and
// ends in the wide coupling.
constexpr Section kHandle[] = {circle(0.0, 3.6, 15.4),   circle(5.0, 3.4, 16.0),   circle(11.0, 3.4, 17.8),
                               circle(18.0, 3.9, 20.3),  circle(25.0, 4.8, 22.7),  circle(32.0, 6.0, 24.5),
                               circle(39.0, 7.0, 25.7),  circle(47.0, 7.7, 26.5),  circle(58.0, 8.2, 27.2),
                               circle(58.6, 7.7, 27.22), circle(59.3, 7.7, 27.26), circle(60.0, 8.5, 27.3),
                               circle(66.0, 9.2, 27.6),  circle(78.0, 9.8, 28.1),  circle(78.6, 9.3, 28.12),
                               circle(79.4, 9.3, 28.16), circle(80.0, 10.0, 28.2), circle(88.0, 10.0, 28.5)};

constexpr HandpieceForm kForm{.head = kHead,

                              .headTop = kHeadTop,
                              .headEdge = 0.6,
                              .handle = kHandle,
                              .handleEnd = 88.0,
                              .handleEdge = 0.8,
                              .fillet = 2.4,
                              .filletFrom = 17.6,
                              .filletTo = 19.6,
                              .halfWidth = 11,
                              .top = 40,
                              .cellSize = 0.4};

constexpr Flutes kFlutes{.from = 66, .to = 75, .depth = 0.3, .count = 16};  // along the coupling

/// The lever on the cap that releases the bur.
double latch(const Vec3& p) {
    return taperedCapsule(p, Vec3(-2.6, 0, kHeadTop), 0.9, Vec3(3.2, 0, kHeadTop + 0.1), 0.7);
}

}  // namespace

TriangleMesh makeContraAngle(int triangles) {
    const Handpiece body(kForm);
    const auto solid = [&](const Vec3& p) {
        constexpr double kLatchFillet = 0.5;
        return smoothUnion(body(p, fluteDepth(kFlutes, p, body.handleMiddle(p.x()))), latch(p), kLatchFillet);
    };
    return handpieceMesh(kForm, solid, triangles);
}

}  // namespace tactooth
