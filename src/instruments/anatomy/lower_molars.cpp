// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Lower right second and third molar (47, 48). Lengths and diameters: Wheeler's table of average teeth;
// outline and landmarks of the second: after CT scans (docs/teeth.md). All else follows textbook drawings.
#include "instruments/anatomy/lower_second_molar_tables.h"
#include "instruments/anatomy/third_molar_tables.h"
#include "instruments/anatomy/tooth_plans.h"

namespace tactooth {
namespace {

PosteriorToothPlan lowerMolar(const char* name, int fdi, const CrownForm& crown, double root) {
    PosteriorToothPlan plan;
    plan.name = name;
    plan.fdi = fdi;
    plan.bounds = Box3(Vec3(-7, -6.5, -root - 0.8), Vec3(7, 6.5, crown.length + 0.9));
    plan.crown = crownSections(crown);
    plan.cervicalFillet = 0.7;
    plan.cervicalHalfWidth = crown.cervixMesiodistal / 2;
    return plan;
}

}  // namespace

PosteriorToothPlan lowerSecondMolar() {
    CrownForm crown{.length = 7.0,
                    .mesiodistal = 10.5,
                    .buccolingual = 10.0,
                    .cervixMesiodistal = 7.95,
                    .cervixBuccolingual = 9.3,
                    .mesialContact = 0.66,
                    .distalContact = 0.50,
                    .buccalCrest = 0.24,
                    .lingualCrest = 0.52,
                    .mesialTop = 0.88,
                    .distalTop = 0.86,
                    .buccalTop = 0.66,
                    .lingualTop = 0.80,
                    .flare = 0.85,
                    .topSquareness = 2.6};
    PosteriorToothPlan plan = lowerMolar("Lower right second molar", 47, crown, 13.0);
    plan.lingualRise = 1.5;
    plan.narrowsLingually = 0.006;
    plan.narrowsDistally = 0.020;
    plan.fossa = 4.6;
    plan.top = 7.0;
    plan.outline = lower_second::kOutline;
    plan.cusps = lower_second::kCusps;
    plan.ridges = lower_second::kRidges;
    plan.grooves = lower_second::kGrooves;
    plan.pits = lower_second::kPits;
    plan.landmarks = lower_second::kLandmarks;
    plan.developmentalGrooves = {{true, -0.30, 0.38, 0.58}, {false, 0.12, 0.30, 0.58}};
    addRoot(plan,
            {.length = 13.0,
             .cervixX = 1.9,
             .cervixY = 0,
             .bendX = 2.6,
             .bendY = 0,
             .apexX = 0.5,
             .apexY = 0,
             .halfMesiodistal = 1.85,
             .halfBuccolingual = 4.25,
             .squareness = 2.6},
            {{1.5, 0.34, 0.36}, {-1.5, 0.34, 0.36}}, 0.35);
    addRoot(plan,
            {.length = 12.4,
             .cervixX = -2.0,
             .cervixY = 0,
             .bendX = -2.7,
             .bendY = 0,
             .apexX = -3.1,
             .apexY = 0,
             .halfMesiodistal = 1.75,
             .halfBuccolingual = 3.8,
             .squareness = 2.5},
            {{0, 0.45, 0.95}}, 0.2);
    plan.chamber = Vec3(-0.1, 0, 0.25);
    plan.chamberHalf = Vec3(2.35, 1.9, 0.78);
    return plan;
}

PosteriorToothPlan lowerThirdMolar() {
    CrownForm crown{.length = 7.0,
                    .mesiodistal = 10.0,
                    .buccolingual = 9.5,
                    .cervixMesiodistal = 7.5,
                    .cervixBuccolingual = 9.2,
                    .mesialContact = 0.64,
                    .distalContact = 0.56,
                    .buccalCrest = 0.30,
                    .lingualCrest = 0.52,
                    .mesialTop = 0.80,
                    .distalTop = 0.74,
                    .buccalTop = 0.58,
                    .lingualTop = 0.70,
                    .cervixSquareness = 2.3,
                    .topSquareness = 2.2};
    PosteriorToothPlan plan = lowerMolar("Lower right third molar", 48, crown, 11.0);
    plan.lingualRise = 1.3;
    plan.narrowsLingually = 0.012;
    plan.narrowsDistally = 0.028;
    plan.fossa = 4.5;
    plan.tip = 0.45;
    plan.top = 7.0;
    plan.outline = lower_third::kOutline;
    plan.cusps = lower_third::kCusps;
    plan.ridges = lower_third::kRidges;
    plan.grooves = lower_third::kGrooves;
    plan.pits = lower_third::kPits;
    plan.landmarks = lower_third::kLandmarks;
    plan.developmentalGrooves = {{true, 0.45, 0.28, 0.58}, {true, -2.55, 0.16, 0.50}, {false, 0.13, 0.24, 0.58}};
    addRoot(plan,
            {.length = 11.0,
             .cervixX = 1.5,
             .cervixY = 0,
             .bendX = 1.9,
             .bendY = 0.1,
             .apexX = -0.7,
             .apexY = 0.2,
             .halfMesiodistal = 1.95,
             .halfBuccolingual = 4.2,
             .squareness = 2.4},
            {{1.1, 0.32, 0.36}, {-1.1, 0.32, 0.36}}, 0.3);
    addRoot(plan,
            {.length = 10.2,
             .cervixX = -1.7,
             .cervixY = 0,
             .bendX = -2.3,
             .bendY = 0,
             .apexX = -3.3,
             .apexY = 0,
             .halfMesiodistal = 1.75,
             .halfBuccolingual = 3.5,
             .squareness = 2.4},
            {{0, 0.42, 0.85}}, 0.2);
    plan.chamber = Vec3(-0.1, 0, 0.25);
    plan.chamberHalf = Vec3(2.1, 1.8, 0.75);
    return plan;
}

}  // namespace tactooth
