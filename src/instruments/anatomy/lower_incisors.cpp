// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Lower right incisors (41, 42). Lengths, diameters and cervical curves: Wheeler's table of average teeth. Between them
// thicknesses, outlines, edges and the lean of the roots follow CT scans, brought to Wheeler's diameters.
#include "instruments/anatomy/anterior_tooth.h"

namespace tactooth {
namespace {

// Columns of a section: z, mesial, distal, labial, lingual, squareness, x, y.

/// A chisel with a smooth lingual face and a flat root; the mesial corner is the sharper one.
AnteriorToothPlan central() {
    return {
        .name = "Lower right central incisor",
        .fdi = 41,
        .body = {{-12.5, 0.42, 0.42, 0.60, 0.55, 2.0},
                 {-11.6, 0.68, 0.68, 1.05, 1.00, 2.0},
                 {-9.0, 1.02, 1.02, 1.85, 1.80, 2.1},
                 {-5.5, 1.33, 1.33, 2.40, 2.40, 2.2},
                 {-2.2, 1.56, 1.56, 2.64, 2.62, 2.2},
                 {0.0, 1.69, 1.67, 2.72, 2.66, 2.1},
                 {0.9, 1.77, 1.74, 2.95, 2.82, 2.1},
                 {2.0, 1.83, 1.79, 3.14, 2.80, 2.1},
                 {3.0, 1.88, 1.88, 3.12, 2.50, 2.15},
                 {4.0, 2.17, 2.16, 3.02, 1.95, 2.2},
                 {5.0, 2.34, 2.32, 2.82, 1.30, 2.3},
                 {6.0, 2.46, 2.45, 2.50, 0.72, 2.4},
                 {7.0, 2.52, 2.48, 2.10, 0.42, 2.5},
                 {8.0, 2.50, 2.42, 1.62, 0.28, 2.6},
                 {8.5, 2.47, 2.36, 1.42, 0.20, 2.6},
                 {9.0, 2.43, 2.28, 1.20, 0.12, 2.6},
                 {10.0, 2.35, 2.15, 0.90, 0.10, 2.6}},
        .bend = {.mesialArch = 0.04, .distalArch = 0.30, .turn = 0.02, .shear = 0.12, .taper = 0.05},
        .apex = -12.55,
        .lean = 0.5,
        .distally = 0.3,
        .edgeZ = 9.0,
        .fall = {{-2.13, 0.45}, {-1.38, 0.14}, {-0.69, 0.05}, {0, 0.02}, {0.69, 0}, {1.38, 0.03}, {2.07, 0.20}},
        .crestY = 0.53,
        .labialBevel = 1.0,
        .lingualBevel = 1.0,
        .edgeRoundness = 0.5,
        .labial = {{0.5, {{0.75, 8.6, -0.05}, {0.8, 6.6, -0.03}}}, {0.5, {{-0.85, 8.4, -0.06}, {-0.75, 6.0, -0.03}}}},
        .lingual = {{0.5, {{1.9, 8.0, 0.08}, {1.75, 6.6, 0.15}, {1.3, 4.8, 0.10}}},
                    {0.55, {{-1.95, 7.8, 0.06}, {-1.8, 6.2, 0.10}, {-1.2, 4.9, 0.05}}},
                    {0.65, {{-0.35, 7.2, -0.05}, {-0.55, 5.4, -0.12}}}},
        .mesialRise = 3.0,
        .distalRise = 2.0,
        .cervicalHalfWidth = 1.8,
        .enamelThickness = 0.95,
        .incisalEnamel = 1.25,
        .pulp = {{-11.7, 0.12, 0.12, 0.13, 0.13, 2.0},
                 {-8.0, 0.24, 0.24, 0.50, 0.50, 2.0},
                 {-3.0, 0.36, 0.36, 0.85, 0.85, 2.1},
                 {0.5, 0.52, 0.52, 0.95, 0.95, 2.1},
                 {3.2, 0.60, 0.60, 0.55, 0.55, 2.2, 0.0, 0.3},
                 {5.4, 0.55, 0.55, 0.18, 0.18, 2.4, 0.0, 0.85}},
        .lesionFrom = Vec3(0.4, 0.6, 6.0),
        .lesionToward = Vec3(5.0, 0.6, 6.0),
    };
}

/// Its crown is twisted on the root: the edge follows the arch.
AnteriorToothPlan lateral() {
    return {
        .name = "Lower right lateral incisor",
        .fdi = 42,
        .body = {{-14.0, 0.46, 0.46, 0.66, 0.60, 2.0},
                 {-13.0, 0.76, 0.76, 1.15, 1.10, 2.0},
                 {-10.1, 1.15, 1.15, 2.00, 1.95, 2.1},
                 {-6.2, 1.50, 1.50, 2.60, 2.60, 2.2},
                 {-2.5, 1.74, 1.73, 2.86, 2.84, 2.2},
                 {0.0, 1.82, 1.80, 2.92, 2.88, 2.1},
                 {1.0, 1.87, 1.88, 3.18, 3.10, 2.1},
                 {2.5, 2.00, 2.05, 3.36, 2.95, 2.1},
                 {3.5, 2.15, 2.20, 3.24, 2.48, 2.15},
                 {4.5, 2.36, 2.42, 3.02, 1.80, 2.2},
                 {5.5, 2.54, 2.62, 2.72, 1.08, 2.3},
                 {6.5, 2.68, 2.74, 2.40, 0.65, 2.4},
                 {7.5, 2.75, 2.75, 2.08, 0.42, 2.5},
                 {8.5, 2.74, 2.66, 1.65, 0.30, 2.6},
                 {9.0, 2.70, 2.58, 1.38, 0.20, 2.6},
                 {9.5, 2.64, 2.48, 1.15, 0.15, 2.6},
                 {10.5, 2.55, 2.35, 0.90, 0.10, 2.6}},
        .bend = {.mesialArch = 0.0, .distalArch = 0.40, .turn = 0.12, .shear = 0.12, .taper = 0.05},
        .apex = -14.05,
        .lean = 1.6,
        .distally = 0.5,
        .edgeZ = 9.5,
        .fall = {{-2.33, 0.62}, {-1.58, 0.26}, {-0.84, 0.12}, {-0.1, 0.05}, {0.7, 0}, {1.44, 0.03}, {2.18, 0.20}},
        .crestY = 0.53,
        .labialBevel = 1.0,
        .lingualBevel = 1.0,
        .edgeRoundness = 0.5,
        .labial = {{0.55, {{0.8, 9.1, -0.05}, {0.9, 7.0, -0.03}}}, {0.55, {{-0.95, 8.8, -0.07}, {-0.8, 6.4, -0.03}}}},
        .lingual = {{0.55, {{2.1, 8.5, 0.10}, {1.9, 7.0, 0.20}, {1.4, 5.2, 0.12}}},
                    {0.6, {{-2.15, 8.2, 0.06}, {-2.0, 6.6, 0.12}, {-1.3, 5.1, 0.06}}},
                    {0.7, {{-0.4, 7.6, -0.06}, {-0.7, 5.7, -0.15}}}},
        .mesialRise = 3.0,
        .distalRise = 2.0,
        .cervicalHalfWidth = 2.0,
        .enamelThickness = 0.95,
        .incisalEnamel = 1.25,
        .pulp = {{-13.1, 0.12, 0.12, 0.13, 0.13, 2.0},
                 {-9.0, 0.26, 0.26, 0.54, 0.54, 2.0},
                 {-3.4, 0.40, 0.40, 0.92, 0.92, 2.1},
                 {0.5, 0.56, 0.56, 1.00, 1.00, 2.1},
                 {3.4, 0.66, 0.66, 0.58, 0.58, 2.2, 0.0, 0.4},
                 {5.7, 0.60, 0.60, 0.19, 0.19, 2.4, 0.0, 0.85}},
        .lesionFrom = Vec3(0.4, 0.6, 6.3),
        .lesionToward = Vec3(5.0, 0.6, 6.3),
    };
}

}  // namespace

ToothShape lowerCentralIncisor() { return anteriorTooth(central()); }

ToothShape lowerLateralIncisor() { return anteriorTooth(lateral()); }

}  // namespace tactooth
