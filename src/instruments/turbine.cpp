// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/turbine.h"

#include <algorithm>
#include <cmath>

#include "instruments/modelling/handpiece.h"

namespace tactooth {
namespace {

// The head around the axis of the bur, 10.6 mm wide and 13 mm high: chuck nose, barrel, groove, push button.
constexpr Section kHead[] = {circle(9.0, 2.5),   circle(9.7, 2.55),  circle(9.9, 3.3),    circle(10.4, 4.2),
                             circle(11.4, 4.85), circle(13.0, 5.2),  circle(15.5, 5.3),   circle(18.2, 5.25),
                             circle(19.0, 5.1),  circle(19.3, 4.9),  circle(19.75, 4.35), circle(20.25, 4.35),
                             circle(20.7, 4.75), circle(21.3, 4.65), circle(22.4, 4.0)};

// The handle along +x, as sections whose first axis is z: a slender neck that rises by 22.5 degrees, then the body,
// bent back (contra-angle), with a coupling ring near its end.
constexpr Section kHandle[] = {
    circle(0.0, 3.6, 15.3),   circle(5.0, 3.35, 16.1), circle(10.0, 3.3, 17.9),  circle(16.0, 3.5, 20.4),
    circle(22.0, 4.0, 22.8),  circle(28.0, 4.6, 24.8), circle(34.0, 5.0, 26.2),  circle(42.0, 5.2, 27.2),
    circle(54.0, 5.2, 28.0),  circle(61.0, 5.0, 28.3), circle(61.6, 4.5, 28.32), circle(62.2, 4.5, 28.34),
    circle(62.8, 5.3, 28.36), circle(66.0, 5.3, 28.5), circle(66.6, 4.7, 28.52), circle(74.0, 4.6, 28.9)};

constexpr HandpieceForm kForm{.head = kHead,

                              .headTop = 22.2,
                              .headEdge = 0.8,
                              .handle = kHandle,
                              .handleEnd = 74.0,
                              .handleEdge = 0.6,
                              .fillet = 2.6,
                              .filletFrom = 17.5,
                              .filletTo = 19.4,
                              .halfWidth = 6.5,
                              .top = 36,
                              .cellSize = 0.3};

/// Ring grooves in the body, for the fingers.
double gripDepth(double x) {
    constexpr double kFirst = 36.0, kLast = 50.0, kSpacing = 2.0, kWidth = 0.45, kDepth = 0.22;
    if (x < kFirst - kSpacing || x > kLast + kSpacing) return 0;
    const double nearest = std::clamp(std::round((x - kFirst) / kSpacing) * kSpacing + kFirst, kFirst, kLast);
    return kDepth * bump(x - nearest, kWidth);
}

}  // namespace

TriangleMesh makeTurbine(int triangles) {
    const Handpiece body(kForm);
    return handpieceMesh(
        kForm, [&](const Vec3& p) { return body(p, gripDepth(p.x())); }, triangles);
}

}  // namespace tactooth
