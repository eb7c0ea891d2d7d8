// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Upper right molars (16, 17, 18). Lengths and diameters: Wheeler's table of average teeth; pulp chambers: A. S.
// Deutsch, B. L. Musikant, J. Endod. 30 (2004) 388; crowns of the first two: after CT scans (docs/teeth.md). All else
// follows textbook drawings.
#include <cmath>

#include "instruments/anatomy/third_molar_tables.h"
#include "instruments/anatomy/tooth_plans.h"
#include "instruments/anatomy/upper_molar_tables.h"

namespace tactooth {
namespace {

/// The common form of the upper molars: a rhombus with its sharp corners mesiobuccally and distolingually, three roots,
/// and enamel that is thickest over the palatal cusps.
PosteriorToothPlan upperMolar(const char* name, int fdi, double length, double cervixMesiodistal) {
    PosteriorToothPlan plan;
    plan.name = name;
    plan.fdi = fdi;
    plan.bounds = Box3(Vec3(-7, -7.5, -14.5), Vec3(7, 7.5, length + 0.9));
    plan.skew = 0.11;
    plan.narrowsDistally = 0.012;
    plan.tip = 0.40;
    plan.enamel = 1.55;
    plan.functionalSide = -1;
    plan.trunkEnd = -3.0;
    plan.mesialRise = 1.0;
    plan.distalRise = 0.2;
    plan.projectionX = 0;
    plan.cervicalHalfWidth = cervixMesiodistal / 2;
    plan.chamberRound = 0.6;
    plan.hornBase = 0.55;
    plan.hornRise = 5.1;
    return plan;
}

}  // namespace

PosteriorToothPlan upperFirstMolar() {
    PosteriorToothPlan plan = upperMolar("Upper right first molar", 16, 7.5, 7.65);
    plan.top = 7.5;
    plan.fossa = 4.4;
    plan.tip = 0.5;
    plan.crown = upper_first::kCrown;
    plan.outline = upper_first::kOutline;
    plan.cusps = upper_first::kCusps;
    plan.ridges = upper_first::kRidges;
    plan.grooves = upper_first::kGrooves;
    plan.pits = upper_first::kPits;
    plan.landmarks = upper_first::kLandmarks;
    plan.developmentalGrooves = {{true, -0.50, 0.34, 0.60}, {false, -1.55, 0.34, 0.62}};
    plan.trunkEnd = -4.3;
    addRoot(plan,
            {.length = 12.0,
             .cervixX = 1.9,
             .cervixY = 2.2,
             .bendX = 3.7,
             .bendY = 3.4,
             .apexX = 1.5,
             .apexY = 3.2,
             .halfMesiodistal = 1.75,
             .halfBuccolingual = 2.6,
             .squareness = 2.4},
            {{1.0, 0.32, 0.38}, {-0.85, 0.26, 0.30}}, 0.25);
    addRoot(plan,
            {.length = 11.6,
             .cervixX = -1.6,
             .cervixY = 2.3,
             .bendX = -2.9,
             .bendY = 3.3,
             .apexX = -2.3,
             .apexY = 3.4,
             .halfMesiodistal = 1.6,
             .halfBuccolingual = 2.1},
            {{0, 0.36, 0.42}});
    addRoot(plan,
            {.length = 13.0,
             .cervixX = 0,
             .cervixY = -2.5,
             .bendX = -0.2,
             .bendY = -5.6,
             .apexX = -0.1,
             .apexY = -4.2,
             .halfMesiodistal = 2.6,
             .halfBuccolingual = 2.2,
             .squareness = 2.2},
            {{0, 0.55, 0.45}});
    plan.chamber = Vec3(-0.1, 0.1, 0.45);
    plan.chamberHalf = Vec3(2.0, 2.6, 0.85);
    return plan;
}

PosteriorToothPlan upperSecondMolar() {
    PosteriorToothPlan plan = upperMolar("Upper right second molar", 17, 7.0, 6.8);
    plan.top = 7.0;
    plan.fossa = 4.2;
    plan.crown = upper_second::kCrown;
    plan.outline = upper_second::kOutline;
    plan.cusps = upper_second::kCusps;
    plan.ridges = upper_second::kRidges;
    plan.grooves = upper_second::kGrooves;
    plan.pits = upper_second::kPits;
    plan.landmarks = upper_second::kLandmarks;
    plan.developmentalGrooves = {{true, -0.45, 0.32, 0.58}, {false, -1.50, 0.14, 0.60}};
    plan.trunkEnd = -4.0;
    addRoot(plan,
            {.length = 11.0,
             .cervixX = 1.6,
             .cervixY = 2.1,
             .bendX = 2.5,
             .bendY = 3.0,
             .apexX = 0.3,
             .apexY = 2.8,
             .halfMesiodistal = 1.6,
             .halfBuccolingual = 2.6,
             .squareness = 2.4},
            {{0.6, 0.32, 0.45}}, 0.2);
    addRoot(plan,
            {.length = 10.7,
             .cervixX = -1.25,
             .cervixY = 2.2,
             .bendX = -2.7,
             .bendY = 2.8,
             .apexX = -2.7,
             .apexY = 2.8,
             .halfMesiodistal = 1.45,
             .halfBuccolingual = 2.1},
            {{0, 0.34, 0.42}});
    addRoot(plan,
            {.length = 12.0,
             .cervixX = 0,
             .cervixY = -2.4,
             .bendX = -0.5,
             .bendY = -4.6,
             .apexX = -0.9,
             .apexY = -3.4,
             .halfMesiodistal = 2.3,
             .halfBuccolingual = 2.2},
            {{0, 0.50, 0.45}});
    plan.chamber = Vec3(-0.1, 0.1, 0.35);
    plan.chamberHalf = Vec3(1.7, 2.5, 0.82);
    return plan;
}

PosteriorToothPlan upperThirdMolar() {
    CrownForm crown{.length = 6.5,
                    .mesiodistal = 8.32,
                    .buccolingual = 10.0,
                    .cervixMesiodistal = 6.1,
                    .cervixBuccolingual = 9.8,
                    .mesialContact = 0.62,
                    .distalContact = 0.52,
                    .buccalCrest = 0.25,
                    .lingualCrest = 0.48,
                    .mesialTop = 0.82,
                    .distalTop = 0.74,
                    .buccalTop = 0.74,
                    .lingualTop = 0.62,
                    .cervixSquareness = 2.3,
                    .topSquareness = 2.15};
    PosteriorToothPlan plan = upperMolar("Upper right third molar", 18, crown.length, crown.cervixMesiodistal);
    plan.crown = crownSections(crown);
    plan.skew = 0.10;
    plan.narrowsLingually = 0.03;
    plan.narrowsDistally = 0.03;
    plan.fossa = 3.9;
    plan.tip = 0.45;
    plan.top = 6.5;
    plan.outline = upper_third::kOutline;
    plan.cusps = upper_third::kCusps;
    plan.ridges = upper_third::kRidges;
    plan.grooves = upper_third::kGrooves;
    plan.pits = upper_third::kPits;
    plan.landmarks = upper_third::kLandmarks;
    plan.developmentalGrooves = {{true, -0.25, 0.28, 0.60}};
    addRoot(plan,
            {.length = 11.0,
             .cervixX = 1.2,
             .cervixY = 1.8,
             .bendX = 1.6,
             .bendY = 2.2,
             .apexX = -1.4,
             .apexY = 1.7,
             .halfMesiodistal = 1.75,
             .halfBuccolingual = 2.6},
            {{0.3, 0.32, 0.42}}, 0.15);
    addRoot(plan,
            {.length = 10.2,
             .cervixX = -1.2,
             .cervixY = 1.7,
             .bendX = -2.2,
             .bendY = 2.1,
             .apexX = -2.9,
             .apexY = 1.8,
             .halfMesiodistal = 1.4,
             .halfBuccolingual = 2.0},
            {{0, 0.32, 0.38}});
    addRoot(plan,
            {.length = 10.8,
             .cervixX = -0.1,
             .cervixY = -2.0,
             .bendX = -0.6,
             .bendY = -3.0,
             .apexX = -1.8,
             .apexY = -1.6,
             .halfMesiodistal = 2.3,
             .halfBuccolingual = 2.3},
            {{0, 0.45, 0.42}});
    plan.chamber = Vec3(-0.1, 0.1, 0.25);
    plan.chamberHalf = Vec3(1.5, 2.1, 0.75);
    return plan;
}

}  // namespace tactooth
