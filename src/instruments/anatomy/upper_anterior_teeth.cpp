// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Upper right incisors (11, 12) and canine (13), and the lower right canine (43), which is derived from the upper one.
// Lengths, diameters and cervical curves: Wheeler's table of average teeth. The outlines between follow textbook
// drawings.
#include "instruments/anatomy/anterior_tooth.h"

namespace tactooth {

// Columns of a section: z, mesial, distal, buccal, lingual, squareness, x, y.

namespace {

constexpr AnteriorToothSize kUpperCentral{10.5, 13.0, 8.5, 7.0, 7.0, 6.0},
    kUpperLateral{9.0, 13.0, 6.5, 4.82, 6.0, 5.0};  // gives the width of the table at the neck, once its line is curved
constexpr AnteriorToothSize kUpperCanine{10.0, 17.0, 7.5, 5.5, 8.0, 7.0}, kLowerCanine{11.0, 16.0, 7.0, 5.5, 7.5, 7.0};

AnteriorToothPlan upperCentral() {
    return {
        .name = "Upper right central incisor",
        .fdi = 11,
        .body = {{-13.0, 0.75, 0.75, 0.80, 0.75, 2.0, -0.45, 0.0},
                 {-12.0, 1.15, 1.15, 1.20, 1.10, 2.0, -0.35, 0.0},
                 {-9.5, 1.85, 1.85, 1.95, 1.85, 2.0, -0.15, 0.0},
                 {-6.0, 2.55, 2.55, 2.60, 2.50, 2.1},
                 {-2.5, 3.05, 3.05, 2.95, 2.85, 2.1},
                 {0.0, 3.30, 3.30, 3.08, 3.05, 2.1},
                 {1.3, 3.40, 3.42, 3.48, 3.50, 2.1},
                 {2.8, 3.52, 3.62, 3.50, 2.95, 2.2},
                 {4.5, 3.86, 3.96, 3.25, 1.75, 2.4},
                 {6.5, 4.14, 4.20, 2.75, 0.75, 2.7},
                 {8.5, 4.28, 4.22, 2.15, 0.05, 3.0},
                 {10.5, 4.20, 3.70, 1.40, -0.30, 3.2},
                 {12.0, 3.95, 3.10, 0.95, -0.25, 3.2}},
        .apex = -13.05,
        .edgeX = 0.9,
        .edgeZ = 10.68,
        .mesialEdgeSlope = 0.06,
        .distalEdgeSlope = 0.20,
        .edgeRoundness = 1.5,
        .bevel = 0.55,
        .labial = {{1.35, 0.7, 6.0, 10.5, 0.10}, {-1.35, 0.7, 6.0, 10.5, 0.10}},
        .lingual = {{0.0, 2.1, 4.0, 8.6, 0.55}},
        .mesialRise = 3.5,
        .distalRise = 2.5,
        .cervicalHalfWidth = 3.6,
        .enamelThickness = 0.85,
        .incisalEnamel = 2.1,
        .pulp = {{-12.2, 0.14, 0.14, 0.14, 0.14, 2.0, -0.35, 0.0},
                 {-8.0, 0.40, 0.40, 0.42, 0.40, 2.0, -0.05, 0.0},
                 {-3.0, 0.70, 0.70, 0.62, 0.60, 2.0},
                 {0.5, 1.15, 1.15, 0.85, 0.80, 2.1, 0.0, 0.1},
                 {3.5, 1.55, 1.55, 0.60, 0.60, 2.3, 0.0, 0.65},
                 {6.2, 1.75, 1.75, 0.22, 0.22, 2.5, 0.0, 0.95}},
        .lesionFrom = Vec3(1.0, 0.8, 7.0),
        .lesionToward = Vec3(6.0, 0.8, 7.0),
    };
}

AnteriorToothPlan canine() {
    return {
        .name = "Upper right canine",
        .fdi = 13,
        .body = {{-17.0, 0.60, 0.60, 0.75, 0.70, 2.0, -0.70, 0.0},
                 {-15.8, 0.95, 0.95, 1.25, 1.20, 2.0, -0.50, 0.0},
                 {-12.5, 1.50, 1.50, 2.15, 2.10, 2.1, -0.20, 0.0},
                 {-8.0, 2.05, 2.05, 2.95, 2.95, 2.2},
                 {-3.0, 2.50, 2.50, 3.45, 3.45, 2.2},
                 {0.0, 2.68, 2.68, 3.55, 3.55, 2.1},
                 {1.6, 2.76, 2.80, 4.00, 3.98, 2.05},
                 {2.8, 2.92, 3.12, 4.08, 3.40, 2.05},
                 {4.5, 3.38, 3.60, 3.80, 2.30, 2.05},
                 {6.2, 3.70, 3.78, 3.30, 1.40, 2.1},
                 {7.6, 3.72, 3.55, 2.65, 0.80, 2.2},
                 {9.0, 3.40, 3.20, 1.95, 0.25, 2.3},
                 {10.5, 3.00, 2.80, 1.20, -0.15, 2.4}},
        .apex = -17.05,
        .edgeX = 0.25,
        .edgeZ = 10.25,
        .mesialEdgeSlope = 0.62,
        .distalEdgeSlope = 0.78,
        .edgeRoundness = 0.45,
        .bevel = 0.95,
        .labial = {{1.75, 0.9, 4.0, 9.5, 0.16}, {-1.75, 0.9, 4.0, 9.5, 0.16}},
        .lingual = {{1.35, 0.85, 3.8, 7.4, 0.38}, {-1.35, 0.85, 3.8, 7.0, 0.38}},
        .mesialRise = 2.5,
        .distalRise = 1.5,
        .cervicalHalfWidth = 2.85,
        .enamelThickness = 1.0,
        .incisalEnamel = 1.5,
        .pulp = {{-16.2, 0.14, 0.14, 0.15, 0.15, 2.0, -0.50, 0.0},
                 {-10.0, 0.38, 0.38, 0.60, 0.60, 2.0, -0.05, 0.0},
                 {-4.0, 0.60, 0.60, 1.05, 1.05, 2.1},
                 {0.5, 0.80, 0.80, 1.35, 1.25, 2.1, 0.0, 0.1},
                 {3.5, 0.80, 0.80, 0.95, 0.85, 2.1, 0.05, 0.45},
                 {6.6, 0.30, 0.30, 0.28, 0.28, 2.0, 0.15, 0.85}},
        .lesionFrom = Vec3(0.0, 0.0, 1.5),
        .lesionToward = Vec3(0.0, 6.0, 1.5),
    };
}

}  // namespace

ToothShape upperCentralIncisor() { return anteriorTooth(upperCentral()); }

/// Like the central incisor, but with rounder corners, a deeper fossa and a root that bends to distal.
ToothShape upperLateralIncisor() {
    AnteriorToothPlan plan = resized(upperCentral(), kUpperCentral, kUpperLateral, "Upper right lateral incisor", 12);
    plan.edgeX = 0.8;
    plan.mesialEdgeSlope = 0.20;
    plan.distalEdgeSlope = 0.42;
    plan.edgeRoundness = 0.9;
    plan.lingual.front().depth = 0.55;
    plan.mesialRise = 3.0;
    plan.distalRise = 2.0;
    constexpr double kBend = 0.9;  // mm at the apex
    const auto bend = [](double z) { return z < 0 ? -(kBend * z * z / (kUpperLateral.root * kUpperLateral.root)) : 0; };
    shiftCentres(plan.body, bend);
    shiftCentres(plan.pulp, bend);
    return anteriorTooth(plan);
}

ToothShape upperCanine() { return anteriorTooth(canine()); }

/// Narrower and longer than the upper one, with faint lingual ridges and a straight mesial side.
ToothShape lowerCanine() {
    AnteriorToothPlan plan = resized(canine(), kUpperCanine, kLowerCanine, "Lower right canine", 43);
    plan.edgeX = 0.45;
    plan.mesialEdgeSlope = 0.42;
    plan.distalEdgeSlope = 0.66;
    plan.bevel = 0.55;
    for (FaceGroove& furrow : plan.lingual) furrow.depth *= 0.5;
    plan.distalRise = 1.0;
    return anteriorTooth(plan);
}

}  // namespace tactooth
