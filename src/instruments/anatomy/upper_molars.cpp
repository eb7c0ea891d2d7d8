// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Upper right molars (16, 17, 18). Lengths and diameters: Wheeler's table of average teeth; pulp chambers: A. S.
// Deutsch, B. L. Musikant, J. Endod. 30 (2004) 388. All else follows textbook drawings.
#include <cmath>

#include "instruments/anatomy/posterior_tooth.h"
#include "instruments/anatomy/tooth_form.h"

namespace tactooth {
namespace {

/// The common form of the upper molars: a rhombus with its sharp corners mesiobuccally and distolingually, three roots,
/// and enamel that is thickest over the palatal cusps.
PosteriorToothPlan upperMolar(const char* name, int fdi, const CrownForm& crown) {
    PosteriorToothPlan plan;
    plan.name = name;
    plan.fdi = fdi;
    plan.bounds = Box3(Vec3(-7, -7.5, -14.5), Vec3(7, 7.5, crown.length + 0.9));
    plan.crown = crownSections(crown);
    plan.skew = 0.11;
    plan.narrowsDistally = 0.012;
    plan.tip = 0.40;
    plan.functionalSide = -1;
    plan.trunkEnd = -3.0;
    plan.mesialRise = 1.0;
    plan.distalRise = 0.2;
    plan.projectionX = 0;
    plan.cervicalHalfWidth = crown.cervixMesiodistal / 2;
    plan.chamberRound = 0.6;
    plan.hornBase = 0.55;
    plan.hornRise = 5.1;
    return plan;
}

void addRoot(PosteriorToothPlan& plan, const RootForm& form, std::initializer_list<CanalForm> canals,
             double concavity = 0) {
    plan.roots.push_back({rootSections(form), -form.length - 0.05, concavity, form.bendY, 1 - form.length});
    for (const CanalForm& canal : canals) plan.canals.push_back(canalSections(form, canal));
}

}  // namespace

ToothShape upperFirstMolar() {
    CrownForm crown{.length = 7.5,
                    .mesiodistal = 9.85,
                    .buccolingual = 11.0,
                    .cervixMesiodistal = 7.65,
                    .cervixBuccolingual = 10.2,
                    .mesialContact = 0.64,
                    .distalContact = 0.55,
                    .buccalCrest = 0.22,
                    .lingualCrest = 0.45,
                    .mesialTop = 0.84,
                    .distalTop = 0.80,
                    .buccalTop = 0.78,
                    .lingualTop = 0.70,
                    .topSquareness = 2.8};
    PosteriorToothPlan plan = upperMolar("Upper right first molar", 16, crown);
    plan.fossa = 4.55;
    plan.cusps = {{2.45, 3.15, 7.25, -0.25, -0.97, 0.84, 1.30, 0.78},   // mesiobuccal
                  {-1.75, 3.05, 6.95, 0.52, -0.85, 0.72, 1.30, 0.80},   // distobuccal, ridge to the mesiopalatal
                  {1.55, -2.75, 7.55, -0.52, 0.85, 0.66, 1.20, 0.58},   // mesiopalatal, the largest
                  {-3.05, -3.05, 6.25, 0.35, 0.94, 0.80, 1.10, 0.80}};  // distopalatal
    plan.ridges = {{4.30, 1.9, 4.05, -1.5, 6.05, 0.95},
                   {-4.25, 1.5, -4.55, -1.7, 5.45, 0.95},
                   {0.35, -0.9, -0.75, 1.2, 5.75, 0.80}};  // the oblique ridge's middle
    plan.grooves = {{3.35, 0.15, 1.05, 0.55, 0.36, 0.40},    {1.05, 0.55, 0.45, 0.85, 0.38, 0.42},
                    {0.45, 0.85, 0.30, 5.2, 0.36, 0.44},     {0.45, 0.85, -0.55, 0.35, 0.16, 0.36},
                    {-0.55, 0.35, -2.25, -0.35, 0.18, 0.36}, {-3.35, 0.45, -2.25, -0.35, 0.32, 0.38},
                    {-2.25, -0.35, -1.35, -1.9, 0.36, 0.42}, {-1.35, -1.9, -1.05, -5.6, 0.38, 0.46},
                    {3.35, 0.15, 3.85, 1.6, 0.24, 0.36},     {3.35, 0.15, 3.85, -1.0, 0.24, 0.36},
                    {-3.35, 0.45, -3.75, 1.2, 0.22, 0.34},   {1.3, 0.6, 1.75, 2.2, 0.13, 0.34},
                    {2.5, 0.3, 3.1, 2.1, 0.12, 0.32},        {1.9, 0.4, 2.6, -1.6, 0.13, 0.34},
                    {-2.2, 0.3, -2.5, 2.0, 0.12, 0.32}};
    plan.pits = {{0.60, 0.80, 0.26, 0.50}, {3.35, 0.15, 0.22, 0.42}, {-2.60, -0.15, 0.22, 0.44}};
    plan.developmentalGrooves = {{true, 0.35, 0.36, 0.60}, {false, -0.95, 0.38, 0.62}};
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
    return posteriorTooth(plan);
}

ToothShape upperSecondMolar() {
    CrownForm crown{.length = 7.0,
                    .mesiodistal = 8.72,
                    .buccolingual = 11.0,
                    .cervixMesiodistal = 6.7,
                    .cervixBuccolingual = 10.0,
                    .mesialContact = 0.64,
                    .distalContact = 0.55,
                    .buccalCrest = 0.22,
                    .lingualCrest = 0.45,
                    .mesialTop = 0.84,
                    .distalTop = 0.78,
                    .buccalTop = 0.76,
                    .lingualTop = 0.66,
                    .topSquareness = 2.6};
    PosteriorToothPlan plan = upperMolar("Upper right second molar", 17, crown);
    plan.skew = 0.16;
    plan.narrowsDistally = 0.02;
    plan.fossa = 4.25;
    plan.cusps = {{2.25, 3.15, 6.85, -0.25, -0.97, 0.84, 1.30, 0.80},
                  {-1.50, 2.90, 6.35, 0.46, -0.89, 0.74, 1.30, 0.84},
                  {1.05, -2.75, 7.05, -0.40, 0.92, 0.66, 1.20, 0.60},
                  {-2.75, -2.85, 5.45, 0.40, 0.92, 0.82, 1.10, 0.90}};
    plan.ridges = {{3.90, 1.9, 3.55, -1.5, 5.60, 0.95},
                   {-3.80, 1.3, -4.05, -1.5, 4.95, 0.95},
                   {0.15, -0.9, -0.65, 1.1, 5.25, 0.85}};
    plan.grooves = {{3.00, 0.15, 0.95, 0.55, 0.36, 0.40},    {0.95, 0.55, 0.40, 0.80, 0.38, 0.42},
                    {0.40, 0.80, 0.25, 5.2, 0.36, 0.44},     {0.40, 0.80, -0.50, 0.30, 0.18, 0.36},
                    {-0.50, 0.30, -2.00, -0.35, 0.20, 0.36}, {-3.00, 0.40, -2.00, -0.35, 0.30, 0.38},
                    {-2.00, -0.35, -1.30, -1.9, 0.34, 0.42}, {-1.30, -1.9, -1.15, -5.4, 0.34, 0.44},
                    {3.00, 0.15, 3.45, 1.5, 0.22, 0.36},     {3.00, 0.15, 3.35, -1.0, 0.22, 0.36},
                    {1.2, 0.6, 1.6, 2.2, 0.13, 0.34},        {1.6, 0.4, 2.2, -1.5, 0.13, 0.34},
                    {-2.0, 0.3, -2.2, 1.9, 0.12, 0.32}};
    plan.pits = {{0.55, 0.75, 0.25, 0.48}, {3.00, 0.15, 0.20, 0.42}, {-2.30, -0.15, 0.20, 0.42}};
    plan.developmentalGrooves = {{true, 0.30, 0.34, 0.58}, {false, -1.10, 0.34, 0.60}};
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
    return posteriorTooth(plan);
}

ToothShape upperThirdMolar() {
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
    PosteriorToothPlan plan = upperMolar("Upper right third molar", 18, crown);
    plan.skew = 0.10;
    plan.narrowsLingually = 0.03;
    plan.narrowsDistally = 0.03;
    plan.fossa = 3.95;
    plan.tip = 0.5;
    plan.cusps = {{1.95, 2.75, 6.35, -0.30, -0.95, 0.80, 1.20, 0.78},
                  {-1.45, 2.35, 5.80, 0.45, -0.89, 0.78, 1.20, 0.84},
                  {-0.10, -2.35, 6.55, 0.05, 0.99, 0.72, 1.10, 0.62}};
    plan.ridges = {{3.45, 1.7, 3.05, -1.1, 5.15, 0.95}, {-3.45, 1.0, -3.25, -1.2, 4.70, 0.95}};
    plan.grooves = {{2.55, 0.20, 0.50, 0.45, 0.34, 0.42},   {0.50, 0.45, -1.05, 0.10, 0.34, 0.42},
                    {-1.05, 0.10, -2.45, 0.00, 0.28, 0.38}, {0.50, 0.45, 0.15, 4.6, 0.34, 0.44},
                    {-1.05, 0.10, -2.15, -1.6, 0.24, 0.38}, {2.55, 0.20, 3.0, 1.3, 0.20, 0.34},
                    {2.55, 0.20, 2.4, -1.3, 0.20, 0.34},    {0.2, 0.3, 0.9, -1.2, 0.16, 0.34},
                    {-0.6, 0.2, -0.5, -1.2, 0.16, 0.34},    {1.3, 0.5, 1.6, 1.9, 0.14, 0.32},
                    {-1.2, 0.3, -1.6, 1.6, 0.14, 0.32}};
    plan.pits = {{0.45, 0.45, 0.24, 0.48}, {2.55, 0.20, 0.18, 0.40}, {-2.30, 0.00, 0.18, 0.40}};
    plan.developmentalGrooves = {{true, 0.15, 0.28, 0.60}};
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
    return posteriorTooth(plan);
}

}  // namespace tactooth
