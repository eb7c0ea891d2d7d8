// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Lower right second and third molar (47, 48). Lengths and diameters: Wheeler's table of average teeth. All else
// follows textbook drawings.
#include "instruments/anatomy/posterior_tooth.h"
#include "instruments/anatomy/tooth_form.h"

namespace tactooth {
namespace {

void addRoot(PosteriorToothPlan& plan, const RootForm& form, std::initializer_list<CanalForm> canals,
             double concavity) {
    plan.roots.push_back({rootSections(form), -form.length - 0.05, concavity, form.bendY, 1 - form.length});
    for (const CanalForm& canal : canals) plan.canals.push_back(canalSections(form, canal));
}

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

ToothShape lowerSecondMolar() {
    CrownForm crown{.length = 7.0,
                    .mesiodistal = 10.5,
                    .buccolingual = 10.0,
                    .cervixMesiodistal = 7.85,
                    .cervixBuccolingual = 9.3,
                    .mesialContact = 0.66,
                    .distalContact = 0.60,
                    .buccalCrest = 0.28,
                    .lingualCrest = 0.52,
                    .mesialTop = 0.84,
                    .distalTop = 0.82,
                    .buccalTop = 0.58,
                    .lingualTop = 0.74,
                    .topSquareness = 2.6};
    PosteriorToothPlan plan = lowerMolar("Lower right second molar", 47, crown, 13.0);
    plan.narrowsLingually = 0.006;
    plan.narrowsDistally = 0.020;
    plan.fossa = 4.80;
    plan.cusps = {{2.10, 2.40, 6.72, -0.30, -0.954, 0.70, 1.10, 0.56},   // mesiobuccal
                  {-2.45, 2.45, 6.32, 0.26, -0.966, 0.68, 1.10, 0.66},   // distobuccal
                  {2.85, -2.60, 7.12, -0.42, 0.908, 0.72, 1.35, 0.58},   // mesiolingual
                  {-2.00, -2.60, 6.74, 0.12, 0.993, 0.70, 1.35, 0.66}};  // distolingual
    plan.ridges = {{3.85, 1.5, 3.60, -1.5, 5.75, 0.85}, {-3.55, 1.3, -3.40, -1.3, 5.35, 0.85}};
    // One bowl, deepest distal of the middle. The buccal groove meets the wall distal of the lingual one.
    plan.grooves = {{2.75, 0.35, 1.30, -0.15, 0.26, 0.42, 0.34},   {1.30, -0.15, -0.50, 0.25, 0.34, 0.44, 0.42},
                    {-0.50, 0.25, -1.60, -0.05, 0.42, 0.42, 0.30}, {-1.60, -0.05, -2.75, 0.25, 0.30, 0.40, 0.22},
                    {-0.50, 0.25, -0.55, 1.40, 0.42, 0.44, 0.32},  {-0.55, 1.40, -0.25, 4.6, 0.32, 0.44, 0.44},
                    {-0.20, 0.10, 0.15, -1.20, 0.34, 0.42, 0.26},  {0.15, -1.20, 0.30, -4.8, 0.26, 0.44, 0.42},
                    {2.75, 0.35, 3.55, 1.30, 0.24, 0.36, 0.06},    {2.75, 0.35, 3.20, -0.90, 0.14, 0.34, 0.04},
                    {-2.75, 0.25, -3.30, -0.95, 0.22, 0.36, 0.06}, {-1.70, 0.0, -1.45, 1.60, 0.15, 0.32, 0.03},
                    {1.30, -0.15, 1.75, -1.60, 0.15, 0.32, 0.03}};
    plan.pits = {{-0.50, 0.25, 0.26, 0.52}, {2.75, 0.35, 0.12, 0.40}, {-2.75, 0.25, 0.10, 0.40}};
    plan.developmentalGrooves = {{true, -0.25, 0.40, 0.58}, {false, 0.30, 0.32, 0.58}};
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
    return posteriorTooth(plan);
}

ToothShape lowerThirdMolar() {
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
    plan.narrowsLingually = 0.012;
    plan.narrowsDistally = 0.028;
    plan.fossa = 4.45;
    plan.tip = 0.5;
    plan.cusps = {{2.30, 2.30, 6.70, -0.20, -0.98, 0.80, 1.05, 0.66},
                  {-1.00, 2.20, 6.40, 0.15, -0.99, 0.80, 1.05, 0.74},
                  {-2.95, 0.80, 5.85, 0.90, -0.43, 0.70, 1.00, 0.80},
                  {2.05, -2.35, 7.05, -0.20, 0.98, 0.84, 1.25, 0.66},
                  {-1.70, -2.20, 6.60, 0.25, 0.97, 0.82, 1.25, 0.70}};
    plan.ridges = {{4.05, 1.2, 4.00, -1.3, 5.55, 0.95}, {-4.00, 0.2, -3.75, -1.3, 5.25, 0.95}};
    plan.grooves = {{2.95, -0.05, 0.85, -0.30, 0.34, 0.42},  {0.85, -0.30, -0.65, 0.20, 0.36, 0.42},
                    {-0.65, 0.20, -2.70, -0.50, 0.32, 0.42}, {0.85, -0.30, 0.75, 4.3, 0.34, 0.44},
                    {-1.75, -0.2, -2.25, 3.4, 0.28, 0.40},   {0.10, -0.05, 0.20, -4.6, 0.32, 0.44},
                    {2.95, -0.05, 3.45, 1.0, 0.22, 0.34},    {2.95, -0.05, 3.45, -1.1, 0.22, 0.34},
                    {1.6, -0.2, 2.3, 1.7, 0.16, 0.34},       {0.1, 0.0, -0.3, 1.7, 0.16, 0.34},
                    {1.4, -0.2, 1.2, -1.7, 0.16, 0.34},      {-1.2, 0.0, -1.0, -1.7, 0.16, 0.34},
                    {2.0, -0.2, 2.9, -1.5, 0.14, 0.32}};
    plan.pits = {{0.80, -0.25, 0.22, 0.48}, {2.95, -0.05, 0.20, 0.42}, {-2.60, -0.45, 0.20, 0.42}};
    plan.developmentalGrooves = {{true, 0.80, 0.30, 0.58}, {false, 0.20, 0.26, 0.58}};
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
    return posteriorTooth(plan);
}

}  // namespace tactooth
