// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Upper right and lower right premolars (14, 15, 44, 45). Lengths and diameters: Wheeler's table of average teeth;
// sections, outlines and landmarks: after CT scans (docs/teeth.md). All else follows textbook drawings.
#include "instruments/anatomy/tooth_plans.h"

namespace tactooth {
namespace {

PosteriorToothPlan premolar(const char* name, int fdi, const CrownForm& crown, double root) {
    PosteriorToothPlan plan;
    plan.name = name;
    plan.fdi = fdi;
    plan.bounds = Box3(Vec3(-5, -6, -root - 0.8), Vec3(5, 6, crown.length + 0.9));
    plan.crown = crownSections(crown);
    plan.tip = 0.30;
    plan.skewFrom = 0.8;
    plan.enamel = 1.3;
    plan.projection = 0;
    plan.mesialRise = 1.0;
    plan.distalRise = 0.3;
    plan.cervicalHalfWidth = crown.cervixMesiodistal / 2;
    plan.cervicalFillet = 0.2;
    plan.rootTop = 0.25;  // one root is as wide as the neck
    plan.rootTopRound = 0.3;
    plan.trunkEnd = -2.2;
    plan.chamberRound = 0.45;
    plan.hornBase = 0.42;
    plan.hornRise = 4.9;
    return plan;
}

}  // namespace

PosteriorToothPlan upperFirstPremolar() {
    CrownForm crown{.length = 8.5,
                    .mesiodistal = 7.0,
                    .buccolingual = 9.0,
                    .cervixMesiodistal = 4.82,
                    .cervixBuccolingual = 7.90,
                    .mesialContact = 0.62,
                    .distalContact = 0.56,
                    .buccalCrest = 0.45,
                    .lingualCrest = 0.43,
                    .mesialTop = 0.74,
                    .distalTop = 0.74,
                    .buccalTop = 0.62,
                    .lingualTop = 0.60,
                    .flare = 2.4,
                    .cervixSquareness = 2.2,
                    .topSquareness = 2.1};
    PosteriorToothPlan plan = premolar("Upper right first premolar", 14, crown, 14.0);
    plan.outline = {{0.03, 0},       {0, 0},          {-0.029, -0.206}, {0.014, -0.032},
                    {-0.075, 0.080}, {-0.001, 0.026}, {0.006, 0.010}};
    plan.functionalSide = -1;
    plan.narrowsLingually = 0.035;
    plan.skew = 0.06;
    plan.fossa = 5.8;
    // The buccal tip stands a little distal of the middle, the lingual one mesial of it.
    plan.cusps = {{-0.20, 2.55, 8.62, 0.22, -0.976, 0.84, 1.20, 0.64},
                  {0.50, -2.35, 7.72, -0.26, 0.966, 0.70, 1.05, 0.56}};
    plan.ridges = {{2.45, 1.3, 2.00, -1.2, 6.70, 1.05}, {-2.40, 1.5, -2.20, -1.0, 6.60, 1.05}};
    plan.grooves = {{1.60, 0.20, 0.40, -0.10, 0.42, 0.40, 0.32},   {0.40, -0.10, -0.80, 0.25, 0.32, 0.40, 0.36},
                    {-0.80, 0.25, -1.80, -0.05, 0.36, 0.40, 0.44}, {1.60, 0.20, 3.6, -0.35, 0.40, 0.36, 0.24},
                    {1.60, 0.20, 2.10, 1.40, 0.28, 0.34, 0.06},    {1.60, 0.20, 1.70, -0.80, 0.14, 0.32, 0.03},
                    {-1.80, -0.05, -2.00, 1.10, 0.20, 0.34, 0.05}, {-1.80, -0.05, -2.20, -1.30, 0.32, 0.34, 0.08},
                    {-0.80, 0.25, -1.15, 1.50, 0.14, 0.30, 0.03}};
    plan.pits = {{-1.80, -0.05, 0.20, 0.42}, {1.60, 0.20, 0.16, 0.40}};
    plan.top = 8.5;
    plan.landmarks = {{0.28, 2.38, 0.00}, {0.22, -2.32, 0.72}};
    plan.trunkEnd = -2.6;
    addRoot(plan,
            {.length = 14.0,
             .cervixX = 0,
             .cervixY = 1.55,
             .bendX = 0.1,
             .bendY = 2.2,
             .apexX = -0.5,
             .apexY = 2.3,
             .halfMesiodistal = 2.33,
             .halfBuccolingual = 2.3},
            {{0, 0.32, 0.40}});
    addRoot(plan,
            {.length = 13.2,
             .cervixX = 0,
             .cervixY = -1.6,
             .bendX = 0.1,
             .bendY = -2.3,
             .apexX = -0.3,
             .apexY = -2.2,
             .halfMesiodistal = 2.0,
             .halfBuccolingual = 2.2},
            {{0, 0.32, 0.40}});
    plan.chamber = Vec3(0, 0.1, 0.7);
    plan.chamberHalf = Vec3(0.75, 2.25, 1.0);
    return plan;
}

PosteriorToothPlan upperSecondPremolar() {
    CrownForm crown{.length = 8.5,
                    .mesiodistal = 7.0,
                    .buccolingual = 9.0,
                    .cervixMesiodistal = 4.86,
                    .cervixBuccolingual = 7.80,
                    .mesialContact = 0.60,
                    .distalContact = 0.56,
                    .buccalCrest = 0.42,
                    .lingualCrest = 0.45,
                    .mesialTop = 0.82,
                    .distalTop = 0.82,
                    .buccalTop = 0.62,
                    .lingualTop = 0.70,
                    .flare = 2.4,
                    .cervixSquareness = 2.1,
                    .topSquareness = 2.1};
    PosteriorToothPlan plan = premolar("Upper right second premolar", 15, crown, 14.0);
    plan.outline = {{0.03, 0},       {0, 0},           {-0.022, -0.190}, {0.010, -0.019},
                    {-0.060, 0.069}, {-0.009, -0.018}, {0.019, -0.001}};
    plan.functionalSide = -1;
    plan.narrowsLingually = 0.012;
    plan.skew = 0.06;
    plan.fossa = 6.3;
    // The lingual tip stands mesial of the buccal one; the groove between them is short and bends.
    plan.cusps = {{0.10, 2.50, 8.60, -0.22, -0.976, 0.72, 1.15, 0.56},
                  {0.60, -2.30, 8.22, -0.34, 0.940, 0.62, 1.05, 0.54}};
    plan.ridges = {{2.45, 1.2, 2.20, -1.4, 7.10, 1.0}, {-2.35, 1.4, -2.15, -1.0, 6.80, 1.0}};
    plan.grooves = {{1.20, 0.35, 0.20, -0.10, 0.34, 0.38, 0.26},    {0.20, -0.10, -0.60, 0.20, 0.26, 0.38, 0.32},
                    {-0.60, 0.20, -1.35, -0.20, 0.32, 0.40, 0.42},  {1.20, 0.35, 2.05, 1.40, 0.26, 0.34, 0.08},
                    {1.20, 0.35, 1.60, -0.80, 0.16, 0.32, 0.04},    {-1.35, -0.20, -1.90, 0.90, 0.20, 0.32, 0.05},
                    {-1.35, -0.20, -2.20, -1.50, 0.34, 0.36, 0.10}, {-0.60, 0.20, -1.00, 1.60, 0.16, 0.30, 0.03},
                    {0.10, -0.10, -0.10, -1.30, 0.12, 0.28, 0.02}};
    plan.pits = {{-1.35, -0.20, 0.28, 0.44}, {1.20, 0.35, 0.08, 0.36}};
    addRoot(plan,
            {.length = 14.0,
             .cervixX = 0,
             .cervixY = 0,
             .bendX = 0.15,
             .bendY = 0,
             .apexX = -0.8,
             .apexY = 0,
             .halfMesiodistal = 2.42,
             .halfBuccolingual = 3.95,
             .squareness = 2.2},
            {{0, 0.38, 0.95}}, 0.3);
    plan.chamber = Vec3(0, 0.05, 0.7);
    plan.chamberHalf = Vec3(0.72, 2.15, 1.0);
    return plan;
}

PosteriorToothPlan lowerFirstPremolar() {
    CrownForm crown{.length = 8.5,
                    .mesiodistal = 7.0,
                    .buccolingual = 7.5,
                    .cervixMesiodistal = 4.78,
                    .cervixBuccolingual = 6.40,
                    .mesialContact = 0.60,
                    .distalContact = 0.66,
                    .buccalCrest = 0.42,
                    .lingualCrest = 0.58,
                    .mesialTop = 0.66,
                    .distalTop = 0.66,
                    .buccalTop = 0.20,
                    .lingualTop = 0.96,
                    .buccalShift = -0.05,
                    .flare = 2.4,
                    .cervixSquareness = 2.1,
                    .topSquareness = 2.05};
    PosteriorToothPlan plan = premolar("Lower right first premolar", 44, crown, 14.0);
    plan.outline = {{-0.02, 0},      {0, 0},          {-0.017, 0.014}, {0.011, -0.113},
                    {0.021, -0.006}, {-0.011, 0.027}, {0.017, -0.022}};
    plan.enamel = 1.15;
    plan.narrowsLingually = 0.055;
    plan.fossa = 4.9;
    // The transverse ridge runs to distal of the lingual cusp; the distal fossa is the deeper one.
    plan.cusps = {{0.20, 0.90, 8.62, -0.14, -0.990, 0.76, 0.90, 0.62},
                  {0.30, -2.95, 6.30, -0.30, 0.954, 0.45, 1.10, 0.66}};
    plan.ridges = {{2.55, 0.9, 1.55, -2.0, 6.10, 1.10}, {-2.60, 1.1, -1.75, -2.1, 6.15, 1.15}};
    plan.grooves = {{1.30, -1.20, 0.30, -1.80, 0.22, 0.34, 0.12},   {0.30, -1.80, -0.45, -1.65, 0.12, 0.34, 0.26},
                    {-0.45, -1.65, -1.55, -0.75, 0.26, 0.38, 0.42}, {1.30, -1.20, 1.75, 0.4, 0.22, 0.34, 0.05},
                    {-1.55, -0.75, -2.00, 0.9, 0.34, 0.38, 0.08},   {-1.55, -0.75, -1.85, -1.7, 0.22, 0.34, 0.05},
                    {1.30, -1.20, 1.65, -3.9, 0.34, 0.42, 0.30}};  // the last one is the mesiolingual groove
    plan.pits = {{-1.55, -0.75, 0.32, 0.46}, {1.30, -1.20, 0.20, 0.38}};
    plan.top = 8.5;
    // The buccal cusp falls steeply to the fossa; the lingual one is low.
    plan.landmarks = {{0.10, 1.02, 0.00},   {0.10, -0.30, 0.85},  {0.15, -1.00, 1.75}, {0.10, -1.80, 2.65},
                      {0.62, -2.95, 2.25},  {0.65, -3.50, 2.75},  {1.40, -1.20, 2.35}, {1.65, -2.40, 2.85},
                      {-1.50, -0.80, 2.95}, {-1.95, -1.60, 2.40}, {1.80, -0.20, 1.45}, {-1.80, 0.10, 1.75}};
    addRoot(plan,
            {.length = 14.0,
             .cervixX = 0,
             .cervixY = 0,
             .bendX = 0.1,
             .bendY = 0,
             .apexX = -0.5,
             .apexY = 0,
             .halfMesiodistal = 2.27,
             .halfBuccolingual = 3.3,
             .squareness = 2.1},
            {{0, 0.36, 0.72}}, 0.15);
    plan.chamber = Vec3(0, 0.1, 0.8);
    plan.chamberHalf = Vec3(0.68, 1.35, 1.1);
    return plan;
}

PosteriorToothPlan lowerSecondPremolar() {
    CrownForm crown{.length = 8.0,
                    .mesiodistal = 7.0,
                    .buccolingual = 8.0,
                    .cervixMesiodistal = 4.86,
                    .cervixBuccolingual = 6.78,
                    .mesialContact = 0.62,
                    .distalContact = 0.62,
                    .buccalCrest = 0.42,
                    .lingualCrest = 0.55,
                    .mesialTop = 0.78,
                    .distalTop = 0.78,
                    .buccalTop = 0.40,
                    .lingualTop = 0.82,
                    .flare = 2.4,
                    .cervixSquareness = 2.1,
                    .topSquareness = 2.4};
    PosteriorToothPlan plan = premolar("Lower right second premolar", 45, crown, 14.5);
    plan.outline = {{0, 0}, {0, 0}, {0.016, 0.040}, {-0.082, -0.101}, {0.003, 0.007}, {0.006, 0.052}, {-0.014, -0.005}};
    plan.skew = -0.04;
    plan.fossa = 5.5;
    plan.cusps = {{0.25, 1.55, 8.15, -0.20, -0.980, 0.72, 0.90, 0.54},   // buccal
                  {1.35, -2.55, 7.30, -0.45, 0.893, 0.66, 1.25, 0.60},   // mesiolingual
                  {-1.70, -2.40, 6.45, 0.42, 0.908, 0.62, 1.10, 0.70}};  // distolingual
    plan.ridges = {{2.60, 1.0, 2.35, -1.4, 6.65, 1.05}, {-2.50, 1.2, -2.35, -1.2, 6.15, 1.05}};
    // A Y, whose distal arm ends in the deepest pit and whose lingual arm runs between the lingual cusps.
    plan.grooves = {{1.55, 0.10, 0.40, -0.60, 0.24, 0.36, 0.28},    {0.40, -0.60, -0.60, -0.85, 0.28, 0.38, 0.34},
                    {-0.60, -0.85, -1.65, -0.45, 0.34, 0.40, 0.42}, {-0.60, -0.85, -0.45, -2.40, 0.34, 0.40, 0.24},
                    {-0.45, -2.40, -0.35, -4.2, 0.24, 0.40, 0.36},  {1.55, 0.10, 2.10, 1.15, 0.24, 0.34, 0.06},
                    {1.55, 0.10, 1.95, -0.80, 0.12, 0.30, 0.03},    {-1.65, -0.45, -2.15, 0.95, 0.30, 0.36, 0.07},
                    {-1.65, -0.45, -2.20, -1.20, 0.16, 0.32, 0.04}, {-0.60, -0.80, -0.95, 1.10, 0.14, 0.30, 0.02}};
    plan.pits = {{-1.65, -0.45, 0.26, 0.44}, {-0.60, -0.85, 0.12, 0.42}, {1.55, 0.10, 0.12, 0.38}};
    plan.top = 8.0;
    plan.landmarks = {{0.20, 1.52, 0.00},   {1.74, -2.58, 0.66},  {-1.74, -2.40, 1.48}, {-0.60, -0.85, 1.95},
                      {-1.55, -0.55, 2.15}, {1.45, 0.00, 1.50},   {1.70, -0.75, 1.20},  {-2.15, -0.75, 1.98},
                      {-0.45, -2.40, 1.75}, {-2.30, -1.80, 1.95}, {2.10, -1.70, 1.00}};
    addRoot(plan,
            {.length = 14.5,
             .cervixX = 0,
             .cervixY = 0,
             .bendX = 0.1,
             .bendY = 0,
             .apexX = -0.7,
             .apexY = 0,
             .halfMesiodistal = 2.42,
             .halfBuccolingual = 3.5,
             .squareness = 2.15},
            {{0, 0.38, 0.80}}, 0.15);
    plan.chamber = Vec3(0, 0, 0.7);
    plan.chamberHalf = Vec3(0.75, 1.6, 1.0);
    return plan;
}

}  // namespace tactooth
