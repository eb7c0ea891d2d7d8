// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Modelled after drawings of the manufacturers: head 11.4 mm wide and 14 mm high, motor 22 mm wide.
#include "instruments/low_speed_handpiece.h"

#include <algorithm>

#include "instruments/modelling/handpiece.h"

namespace tactooth {
namespace {

// The head around the axis of the bur: a short nose, a wide barrel with the gear in it, a flat cap.
constexpr double kHeadTop = 23.0;
constexpr Section kHead[] = {circle(9.0, 2.6),   circle(9.6, 2.7),   circle(9.9, 3.6),   circle(10.4, 4.7),
                             circle(11.2, 5.3),  circle(12.6, 5.65), circle(19.0, 5.7),  circle(19.5, 5.55),
                             circle(19.9, 5.1),  circle(20.3, 5.1),  circle(20.8, 5.45), circle(22.2, 5.4),
                             circle(22.6, 5.25), circle(23.0, 5.0)};

// The handle along +x, as sections whose first axis is z: a thick neck that rises by 20 degrees, a sheath that is bent
// back, the joint with the motor, and the motor.
constexpr Section kHandle[] = {
    circle(0.0, 4.5, 15.2),   circle(5.0, 4.35, 15.8),   circle(11.0, 4.4, 17.7),  circle(18.0, 5.0, 20.3),
    circle(25.0, 6.0, 22.8),  circle(32.0, 7.1, 24.8),   circle(40.0, 8.0, 26.3),  circle(50.0, 8.7, 27.3),
    circle(56.0, 9.0, 27.7),  circle(56.6, 8.3, 27.74),  circle(57.6, 8.3, 27.8),  circle(58.2, 9.6, 27.84),
    circle(64.0, 10.4, 28.2), circle(65.0, 11.0, 28.25), circle(84.0, 11.0, 29.2), circle(85.0, 10.4, 29.25),
    circle(86.0, 10.4, 29.3), circle(87.0, 11.0, 29.35), circle(94.0, 11.0, 29.7), circle(98.0, 9.6, 29.9)};

constexpr HandpieceForm kForm{.head = kHead,

                              .headTop = kHeadTop,
                              .headEdge = 0.5,
                              .handle = kHandle,
                              .handleEnd = 98.0,
                              .handleEdge = 1.0,
                              .fillet = 2.6,
                              .filletFrom = 17.0,
                              .filletTo = 19.2,
                              .halfWidth = 12,
                              .top = 42,
                              .cellSize = 0.4};

constexpr Flutes kFlutes{.from = 68, .to = 81, .depth = 0.35, .count = 12};  // along the motor

/// The latch that holds the bur: a lever flat on the cap, from its hinge on the side of the handle to a tongue that
/// stands over the edge.
double latch(const Vec3& p) {
    const double lever = taperedCapsule(p, Vec3(3.4, 0, kHeadTop + 0.2), 1.1, Vec3(-4.6, 0, kHeadTop + 0.2), 0.8);
    const double tongue = taperedCapsule(p, Vec3(-4.6, 0, kHeadTop + 0.2), 0.8, Vec3(-5.7, 0, kHeadTop - 0.5), 0.55);
    return std::min(lever, tongue);
}

}  // namespace

TriangleMesh makeLowSpeedHandpiece(int triangles) {
    const Handpiece body(kForm);
    const auto solid = [&](const Vec3& p) {
        constexpr double kLatchFillet = 0.4;
        return smoothUnion(body(p, fluteDepth(kFlutes, p, body.handleMiddle(p.x()))), latch(p), kLatchFillet);
    };
    return handpieceMesh(kForm, solid, triangles);
}

}  // namespace tactooth
