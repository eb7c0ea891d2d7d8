// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Lower right first molar (46). Lengths and diameters: Wheeler's table of average teeth; pulp chamber: A. S. Deutsch,
// B. L. Musikant, J. Endod. 30 (2004) 388. All else follows textbook drawings.
#include "instruments/anatomy/posterior_tooth.h"

namespace tactooth {
namespace {

// z, mesial, distal, buccal, lingual, squareness. Widest mesiodistally at the contacts (z = 5), buccally near the neck,
// lingually in the middle.
const std::vector<Section> kCrown = {
    {-4.2, 2.9, 2.8, 2.6, 2.6, 2.4, 0, 0},     {-2.6, 3.75, 3.70, 3.65, 3.60, 2.5, 0, 0},
    {-1.0, 4.30, 4.28, 4.38, 4.28, 2.5, 0, 0}, {0.0, 4.42, 4.45, 4.60, 4.50, 2.5, 0, 0},
    {1.2, 4.66, 4.80, 5.08, 4.74, 2.5, 0, 0},  {2.3, 5.22, 5.16, 5.32, 5.02, 2.45, 0, 0},
    {3.8, 5.45, 5.40, 5.12, 5.22, 2.4, 0, 0},  {5.0, 5.54, 5.48, 4.58, 5.07, 2.3, 0, 0},
    {6.2, 5.25, 5.15, 3.80, 4.62, 2.25, 0, 0}, {8.0, 4.60, 4.40, 2.90, 3.80, 2.2, 0, 0}};

const std::vector<Section> kMesialRoot = {
    {-14.0, 0.24, 0.22, 0.35, 0.35, 2.0, 1.45, 0.1}, {-13.85, 0.50, 0.46, 0.72, 0.70, 2.0, 1.52, 0.1},
    {-13.5, 0.72, 0.68, 1.18, 1.15, 2.1, 1.62, 0.1}, {-12.7, 1.00, 0.96, 1.80, 1.75, 2.2, 1.88, 0.1},
    {-11.0, 1.28, 1.25, 2.60, 2.50, 2.4, 2.35, 0.0}, {-8.0, 1.55, 1.50, 3.40, 3.30, 2.5, 2.75, 0.0},
    {-5.0, 1.75, 1.65, 3.90, 3.80, 2.6, 2.70, 0.0},  {-2.5, 1.95, 1.90, 4.15, 4.05, 2.6, 2.35, 0.0},
    {0.0, 2.0, 2.0, 4.20, 4.10, 2.6, 2.1, 0.0}};

const std::vector<Section> kDistalRoot = {
    {-13.2, 0.22, 0.22, 0.32, 0.32, 2.0, -3.75, 0.0}, {-13.05, 0.46, 0.46, 0.66, 0.64, 2.0, -3.74, 0.0},
    {-12.7, 0.68, 0.68, 1.08, 1.05, 2.1, -3.71, 0.0}, {-11.9, 0.93, 0.93, 1.60, 1.56, 2.2, -3.63, 0.0},
    {-10.0, 1.22, 1.22, 2.30, 2.25, 2.3, -3.40, 0.0}, {-7.5, 1.48, 1.48, 3.05, 3.00, 2.4, -3.05, 0.0},
    {-5.0, 1.65, 1.72, 3.65, 3.55, 2.5, -2.70, 0.0},  {-2.5, 1.85, 1.90, 4.00, 3.90, 2.6, -2.40, 0.0},
    {0.0, 1.9, 2.0, 4.10, 4.00, 2.6, -2.2, 0.0}};

// Heights, positions and slopes in mm and mm/mm. The lingual cusps are higher, because the tooth leans.
const std::vector<Cusp> kCusps = {{2.55, 2.55, 7.15, -0.22, -0.975, 0.84, 1.10, 0.62},   // mesiobuccal
                                  {-0.75, 2.80, 6.95, 0.05, -0.999, 0.80, 1.10, 0.70},   // distobuccal
                                  {-3.45, 1.55, 6.45, 0.75, -0.661, 0.66, 1.00, 0.72},   // distal
                                  {2.45, -2.80, 7.50, -0.20, 0.980, 0.86, 1.35, 0.58},   // mesiolingual
                                  {-1.75, -2.85, 7.30, 0.18, 0.984, 0.84, 1.35, 0.62}};  // distolingual

const std::vector<OcclusalRidge> kMarginalRidges = {{4.45, 1.3, 4.45, -1.5, 5.95, 0.95},
                                                    {-4.65, 0.2, -4.35, -1.7, 5.65, 0.95}};

// The central groove zigzags from the mesial to the distal pit; grooves leave it between the cusps.
const std::vector<OcclusalGroove> kGrooves = {
    {3.45, -0.15, 1.05, -0.30, 0.36, 0.42},  {1.05, -0.30, -0.60, 0.15, 0.38, 0.42},
    {-0.60, 0.15, -3.25, -0.55, 0.36, 0.42}, {1.05, -0.30, 1.00, 4.6, 0.38, 0.44},
    {-2.15, 0.0, -2.50, 4.0, 0.34, 0.42},    {0.40, -0.15, 0.45, -4.9, 0.36, 0.44},
    {3.45, -0.15, 4.05, 0.85, 0.26, 0.38},   {3.45, -0.15, 4.05, -1.1, 0.26, 0.38},
    {-3.25, -0.55, -3.95, -1.5, 0.26, 0.38}, {2.3, -0.2, 3.1, 1.9, 0.13, 0.35},
    {0.3, 0.0, -0.05, 1.9, 0.13, 0.35},      {-1.5, 0.0, -1.6, 1.9, 0.12, 0.32},
    {2.2, -0.25, 3.2, -1.9, 0.13, 0.35},     {-0.5, 0.0, -0.7, -2.0, 0.13, 0.35},
    {-2.4, -0.2, -2.9, -1.9, 0.12, 0.35}};

const std::vector<OcclusalPit> kPits = {
    {1.05, -0.30, 0.22, 0.50}, {3.45, -0.15, 0.22, 0.45}, {-3.25, -0.55, 0.22, 0.45}};

// Root canals, as sections: the two mesial ones are round and meet near the apex, the distal one is broad.
const std::vector<Section> kMesiobuccalCanal = {{-13.3, 0.13, 0.13, 0.13, 0.13, 2, 1.60, 0.35},
                                                {-9.0, 0.21, 0.21, 0.24, 0.24, 2, 2.65, 1.35},
                                                {-4.0, 0.30, 0.30, 0.33, 0.33, 2, 2.70, 1.90},
                                                {0.3, 0.42, 0.42, 0.45, 0.45, 2, 1.90, 1.20}};
const std::vector<Section> kMesiolingualCanal = {{-13.3, 0.13, 0.13, 0.13, 0.13, 2, 1.60, -0.25},
                                                 {-9.0, 0.21, 0.21, 0.24, 0.24, 2, 2.65, -1.25},
                                                 {-4.0, 0.30, 0.30, 0.33, 0.33, 2, 2.70, -1.80},
                                                 {0.3, 0.42, 0.42, 0.45, 0.45, 2, 1.90, -1.20}};
const std::vector<Section> kDistalCanal = {{-12.5, 0.14, 0.14, 0.18, 0.18, 2, -3.68, 0},
                                           {-8.5, 0.27, 0.27, 0.60, 0.60, 2, -3.20, 0},
                                           {-4.0, 0.40, 0.40, 0.95, 0.95, 2, -2.60, 0},
                                           {0.3, 0.55, 0.55, 1.10, 1.10, 2, -1.95, 0}};

}  // namespace

ToothShape lowerFirstMolar() {
    PosteriorToothPlan plan;
    plan.name = "Lower right first molar";
    plan.fdi = 46;
    plan.bounds = Box3(Vec3(-6.5, -6.5, -14.8), Vec3(6.5, 6.5, 8.2));
    plan.crown = kCrown;
    plan.narrowsLingually = 0.016;
    plan.narrowsDistally = 0.008;
    plan.cusps = kCusps;
    plan.ridges = kMarginalRidges;
    plan.grooves = kGrooves;
    plan.pits = kPits;
    plan.developmentalGrooves = {{true, 1.10, 0.38, 0.55}, {true, -2.55, 0.30, 0.5}, {false, 0.50, 0.34, 0.6}};
    plan.roots = {{kMesialRoot, -14.05, 0.35, 0}, {kDistalRoot, -13.25, 0.6 * 0.35, 0}};
    // Between z = -0.45 and 1.1: 6.4 mm and 8 mm below the highest cusp.
    plan.chamber = Vec3(-0.1, 0, 0.33);
    plan.chamberHalf = Vec3(2.55, 2.0, 0.78);
    plan.canals = {kMesiobuccalCanal, kMesiolingualCanal, kDistalCanal};
    return posteriorTooth(plan);
}

}  // namespace tactooth
