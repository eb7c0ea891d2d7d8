// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Lower right incisors (41, 42). Lengths, diameters and cervical curves: Wheeler's table of average teeth. The outlines
// between follow textbook drawings.
#include "instruments/anatomy/anterior_tooth.h"

namespace tactooth {
namespace {

constexpr AnteriorToothSize kCentral{9.0, 12.5, 5.0, 3.5, 6.0, 5.3}, kLateral{9.5, 14.0, 5.5, 4.0, 6.5, 5.8};

/// A chisel: narrow and symmetric, with a smooth lingual face, an edge behind the root's axis and a flat root.
AnteriorToothPlan central() {
    return {
        .name = "Lower right central incisor",
        .fdi = 41,
        // Columns: z, mesial, distal, labial, lingual, squareness, x, y.
        .body = {{-12.5, 0.42, 0.42, 0.60, 0.55, 2.0, -0.25, 0.0},
                 {-11.6, 0.68, 0.68, 1.05, 1.00, 2.0, -0.20, 0.0},
                 {-9.0, 1.05, 1.05, 1.85, 1.80, 2.1, -0.05, 0.0},
                 {-5.5, 1.35, 1.35, 2.40, 2.40, 2.2},
                 {-2.2, 1.58, 1.58, 2.65, 2.65, 2.2},
                 {0.0, 1.61, 1.61, 2.70, 2.70, 2.1},
                 {1.2, 1.66, 1.66, 2.98, 3.00, 2.1},
                 {2.4, 1.79, 1.79, 2.95, 2.45, 2.2},
                 {4.0, 2.06, 2.06, 2.60, 1.45, 2.4},
                 {6.0, 2.34, 2.34, 1.98, 0.62, 2.7},
                 {8.0, 2.52, 2.50, 1.20, 0.25, 3.0},
                 {9.0, 2.50, 2.46, 0.75, 0.30, 3.2},
                 {10.5, 2.40, 2.36, 0.35, 0.50, 3.2}},
        .apex = -12.55,
        .edgeX = 0.0,
        .edgeZ = 8.88,
        .mesialEdgeSlope = 0.03,
        .distalEdgeSlope = 0.05,
        .edgeRoundness = 0.8,
        .bevel = -0.22,
        .lingual = {{0.0, 1.3, 3.6, 7.0, 0.16}},
        .mesialRise = 3.0,
        .distalRise = 2.0,
        .cervicalHalfWidth = 1.8,
        .enamelThickness = 0.70,
        .incisalEnamel = 1.8,
        .pulp = {{-11.7, 0.12, 0.12, 0.13, 0.13, 2.0, -0.20, 0.0},
                 {-8.0, 0.24, 0.24, 0.50, 0.50, 2.0, -0.02, 0.0},
                 {-3.0, 0.36, 0.36, 0.85, 0.85, 2.1},
                 {0.5, 0.52, 0.52, 0.95, 0.95, 2.1},
                 {3.2, 0.62, 0.62, 0.55, 0.55, 2.2, 0.0, 0.2},
                 {5.2, 0.55, 0.55, 0.18, 0.18, 2.4, 0.0, 0.3}},
        .lesionFrom = Vec3(0.4, 0.2, 6.0),
        .lesionToward = Vec3(5.0, 0.2, 6.0),
    };
}

}  // namespace

ToothShape lowerCentralIncisor() { return anteriorTooth(central()); }

ToothShape lowerLateralIncisor() {
    AnteriorToothPlan plan = resized(central(), kCentral, kLateral, "Lower right lateral incisor", 42);
    plan.edgeX = 0.4;
    plan.distalEdgeSlope = 0.10;
    constexpr double kLean = 0.12;  // mm: the crown leans a little to distal on its root
    shiftCentres(plan.body, [](double z) { return z > 0 ? -(kLean * z / kLateral.crown) : 0; });
    return anteriorTooth(plan);
}

}  // namespace tactooth
