// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Upper right incisors (11, 12) and canine (13); the lower right canine (43), which is made from the upper one.
// Lengths, diameters and cervical curves: Wheeler's table of average teeth; the outlines between are modelled after
// textbook drawings.
#include "instruments/anatomy/anterior_tooth.h"

namespace tactooth {

// Columns of a section: z, mesial, distal, buccal, lingual, squareness, x, y.

namespace {

constexpr AnteriorToothSize kUpperCentral{10.5, 13.0, 8.5, 7.0, 7.0, 6.0},
    kUpperLateral{9.0, 13.0, 6.5, 4.82, 6.0, 5.0};  // as wide at the neck as the table says, once its line is curved
constexpr AnteriorToothSize kUpperCanine{10.0, 17.0, 7.5, 5.5, 8.0, 7.0}, kLowerCanine{11.0, 16.0, 7.0, 5.5, 7.5, 7.0};

AnteriorToothPlan upperCentral() {
    AnteriorToothPlan plan;
    plan.name = "Upper right central incisor";
    plan.fdi = 11;
    plan.body = {{-13.0, 0.75, 0.75, 0.80, 0.75, 2.0, -0.45, 0.0}, {-12.0, 1.15, 1.15, 1.20, 1.10, 2.0, -0.35, 0.0},
                 {-9.5, 1.85, 1.85, 1.95, 1.85, 2.0, -0.15, 0.0},  {-6.0, 2.55, 2.55, 2.60, 2.50, 2.1, 0.0, 0.0},
                 {-2.5, 3.05, 3.05, 2.95, 2.85, 2.1, 0.0, 0.0},    {0.0, 3.30, 3.30, 3.08, 3.05, 2.1, 0.0, 0.0},
                 {1.3, 3.40, 3.42, 3.48, 3.50, 2.1, 0.0, 0.0},     {2.8, 3.52, 3.62, 3.50, 2.95, 2.2, 0.0, 0.0},
                 {4.5, 3.86, 3.96, 3.25, 1.75, 2.4, 0.0, 0.0},     {6.5, 4.14, 4.20, 2.75, 0.75, 2.7, 0.0, 0.0},
                 {8.5, 4.28, 4.22, 2.15, 0.05, 3.0, 0.0, 0.0},     {10.5, 4.20, 3.70, 1.40, -0.30, 3.2, 0.0, 0.0},
                 {12.0, 3.95, 3.10, 0.95, -0.25, 3.2, 0.0, 0.0}};
    plan.apex = -13.05;
    plan.edgeX = 0.9;
    plan.edgeZ = 10.68;
    plan.mesialEdgeSlope = 0.06;
    plan.distalEdgeSlope = 0.20;
    plan.edgeRoundness = 1.5;
    plan.bevel = 0.55;
    plan.labial = {{1.35, 0.7, 6.0, 10.5, 0.10}, {-1.35, 0.7, 6.0, 10.5, 0.10}};
    plan.lingual = {{0.0, 2.1, 4.0, 8.6, 0.55}};
    plan.mesialRise = 3.5;
    plan.distalRise = 2.5;
    plan.cervicalHalfWidth = 3.6;
    plan.enamelThickness = 0.85;
    plan.incisalEnamel = 2.1;
    plan.pulp = {{-12.2, 0.14, 0.14, 0.14, 0.14, 2.0, -0.35, 0.0}, {-8.0, 0.40, 0.40, 0.42, 0.40, 2.0, -0.05, 0.0},
                 {-3.0, 0.70, 0.70, 0.62, 0.60, 2.0, 0.0, 0.0},    {0.5, 1.15, 1.15, 0.85, 0.80, 2.1, 0.0, 0.1},
                 {3.5, 1.55, 1.55, 0.60, 0.60, 2.3, 0.0, 0.65},    {6.2, 1.75, 1.75, 0.22, 0.22, 2.5, 0.0, 0.95}};
    plan.lesionFrom = Vec3(1.0, 0.8, 7.0);
    plan.lesionToward = Vec3(6.0, 0.8, 7.0);
    return plan;
}

AnteriorToothPlan canine() {
    AnteriorToothPlan plan;
    plan.name = "Upper right canine";
    plan.fdi = 13;
    plan.body = {{-17.0, 0.60, 0.60, 0.75, 0.70, 2.0, -0.70, 0.0}, {-15.8, 0.95, 0.95, 1.25, 1.20, 2.0, -0.50, 0.0},
                 {-12.5, 1.50, 1.50, 2.15, 2.10, 2.1, -0.20, 0.0}, {-8.0, 2.05, 2.05, 2.95, 2.95, 2.2, 0.0, 0.0},
                 {-3.0, 2.50, 2.50, 3.45, 3.45, 2.2, 0.0, 0.0},    {0.0, 2.68, 2.68, 3.55, 3.55, 2.1, 0.0, 0.0},
                 {1.6, 2.76, 2.80, 4.00, 3.98, 2.05, 0.0, 0.0},    {2.8, 2.92, 3.12, 4.08, 3.40, 2.05, 0.0, 0.0},
                 {4.5, 3.38, 3.60, 3.80, 2.30, 2.05, 0.0, 0.0},    {6.2, 3.70, 3.78, 3.30, 1.40, 2.1, 0.0, 0.0},
                 {7.6, 3.72, 3.55, 2.65, 0.80, 2.2, 0.0, 0.0},     {9.0, 3.40, 3.20, 1.95, 0.25, 2.3, 0.0, 0.0},
                 {10.5, 3.00, 2.80, 1.20, -0.15, 2.4, 0.0, 0.0}};
    plan.apex = -17.05;
    plan.edgeX = 0.25;
    plan.edgeZ = 10.25;
    plan.mesialEdgeSlope = 0.62;
    plan.distalEdgeSlope = 0.78;
    plan.edgeRoundness = 0.45;
    plan.bevel = 0.95;
    plan.labial = {{1.75, 0.9, 4.0, 9.5, 0.16}, {-1.75, 0.9, 4.0, 9.5, 0.16}};
    plan.lingual = {{1.35, 0.85, 3.8, 7.4, 0.38}, {-1.35, 0.85, 3.8, 7.0, 0.38}};
    plan.mesialRise = 2.5;
    plan.distalRise = 1.5;
    plan.cervicalHalfWidth = 2.85;
    plan.enamelThickness = 1.0;
    plan.incisalEnamel = 1.5;
    plan.pulp = {{-16.2, 0.14, 0.14, 0.15, 0.15, 2.0, -0.50, 0.0}, {-10.0, 0.38, 0.38, 0.60, 0.60, 2.0, -0.05, 0.0},
                 {-4.0, 0.60, 0.60, 1.05, 1.05, 2.1, 0.0, 0.0},    {0.5, 0.80, 0.80, 1.35, 1.25, 2.1, 0.0, 0.1},
                 {3.5, 0.80, 0.80, 0.95, 0.85, 2.1, 0.05, 0.45},   {6.6, 0.30, 0.30, 0.28, 0.28, 2.0, 0.15, 0.85}};
    plan.lesionFrom = Vec3(0.0, 0.0, 1.5);
    plan.lesionToward = Vec3(0.0, 6.0, 1.5);
    return plan;
}

}  // namespace

ToothShape upperCentralIncisor() { return anteriorTooth(upperCentral()); }

/// As the central one, but with rounder corners, a deeper fossa and a root that bends to distal.
ToothShape upperLateralIncisor() {
    AnteriorToothPlan plan = resized(upperCentral(), kUpperCentral, kUpperLateral);
    plan.name = "Upper right lateral incisor";
    plan.fdi = 12;
    plan.edgeX = 0.8;
    plan.mesialEdgeSlope = 0.20;
    plan.distalEdgeSlope = 0.42;
    plan.edgeRoundness = 0.9;
    plan.lingual.front().depth = 0.55;
    plan.mesialRise = 3.0;
    plan.distalRise = 2.0;
    for (std::vector<Section>* sections : {&plan.body, &plan.pulp}) {
        for (Section& s : *sections) {
            constexpr double kBend = 0.9;  // mm at the apex
            if (s.z < 0) s.x -= kBend * s.z * s.z / (kUpperLateral.root * kUpperLateral.root);
        }
    }
    return anteriorTooth(plan);
}

ToothShape upperCanine() { return anteriorTooth(canine()); }

/// Narrower and longer than the upper one, its lingual ridges faint, its mesial side straight.
ToothShape lowerCanine() {
    AnteriorToothPlan plan = resized(canine(), kUpperCanine, kLowerCanine);
    plan.name = "Lower right canine";
    plan.fdi = 43;
    plan.edgeX = 0.45;
    plan.mesialEdgeSlope = 0.42;
    plan.distalEdgeSlope = 0.66;
    plan.bevel = 0.55;
    for (FaceGroove& furrow : plan.lingual) furrow.depth *= 0.5;
    plan.distalRise = 1.0;
    return anteriorTooth(plan);
}

}  // namespace tactooth
