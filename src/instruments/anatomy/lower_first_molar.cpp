// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Lower right first molar (46). Lengths and diameters: Wheeler's table of average teeth; pulp chamber: A. S. Deutsch,
// B. L. Musikant, J. Endod. 30 (2004) 388; crown: after CT scans (docs/teeth.md). All else follows textbook drawings.
#include "instruments/anatomy/tooth_plans.h"

namespace tactooth {
namespace {

// z, mesial, distal, buccal, lingual, squareness. Widest mesiodistally at the contacts (z = 4.3), buccally near the
// neck, lingually in the middle: the crown leans to the tongue.
const std::vector<Section> kCrown = {
    {-5.0, 2.90, 2.80, 2.60, 2.60, 2.4, 0, 0}, {-3.4, 3.70, 3.65, 3.65, 3.60, 2.5, 0, 0},
    {-1.3, 4.18, 4.18, 4.40, 4.15, 2.5, 0, 0}, {0.0, 4.36, 4.40, 4.65, 4.25, 2.5, 0, 0},
    {0.75, 4.46, 4.50, 4.87, 4.33, 2.5, 0, 0}, {1.30, 4.64, 4.68, 5.10, 4.46, 2.5, 0, 0},
    {1.90, 4.86, 4.89, 5.23, 4.61, 2.5, 0, 0}, {2.80, 5.12, 5.14, 5.13, 4.90, 2.45, 0, 0},
    {3.75, 5.42, 5.36, 5.10, 5.10, 2.4, 0, 0}, {4.40, 5.46, 5.42, 5.02, 5.16, 2.4, 0, 0},
    {5.60, 5.36, 5.28, 4.72, 5.12, 2.4, 0, 0}, {7.00, 4.90, 4.80, 4.00, 4.75, 2.4, 0, 0},
    {8.20, 4.40, 4.30, 3.30, 4.30, 2.4, 0, 0}};

const std::vector<Section> kMesialRoot = {
    {-14.0, 0.34, 0.32, 0.44, 0.44, 2.0, 1.45, 0.1}, {-13.85, 0.58, 0.54, 0.76, 0.74, 2.0, 1.52, 0.1},
    {-13.5, 0.80, 0.76, 1.20, 1.17, 2.1, 1.62, 0.1}, {-12.7, 1.00, 0.96, 1.80, 1.75, 2.2, 1.88, 0.1},
    {-11.0, 1.28, 1.25, 2.60, 2.50, 2.4, 2.35, 0.0}, {-8.0, 1.55, 1.50, 3.40, 3.30, 2.5, 2.75, 0.0},
    {-5.0, 1.75, 1.65, 3.90, 3.80, 2.6, 2.70, 0.0},  {-2.5, 1.95, 1.90, 4.15, 4.05, 2.6, 2.35, 0.0},
    {0.0, 2.0, 2.0, 4.20, 4.10, 2.6, 2.1, 0.0}};

const std::vector<Section> kDistalRoot = {
    {-13.2, 0.35, 0.35, 0.48, 0.48, 2.0, -3.75, 0.0}, {-13.05, 0.60, 0.60, 0.84, 0.82, 2.0, -3.74, 0.0},
    {-12.7, 0.78, 0.78, 1.22, 1.18, 2.1, -3.71, 0.0}, {-11.9, 0.93, 0.93, 1.60, 1.56, 2.2, -3.63, 0.0},
    {-10.0, 1.22, 1.22, 2.30, 2.25, 2.3, -3.40, 0.0}, {-7.5, 1.48, 1.48, 3.05, 3.00, 2.4, -3.05, 0.0},
    {-5.0, 1.65, 1.72, 3.65, 3.55, 2.5, -2.70, 0.0},  {-2.5, 1.85, 1.90, 4.00, 3.90, 2.6, -2.40, 0.0},
    {0.0, 1.9, 2.0, 4.10, 4.00, 2.6, -2.2, 0.0}};

// How the outline from above departs from the ovals: squarer, and flatter distally.
const OutlineWaves kOutline = {{0.08, 0},       {0, 0},          {-0.014, 0.024}, {-0.090, -0.104},
                               {-0.091, 0.004}, {-0.064, 0.008}, {-0.056, 0.001}};

// Heights, positions and slopes in mm and mm/mm. The lingual cusps are higher, because the tooth leans.
const std::vector<Cusp> kCusps = {{2.00, 2.30, 7.00, -0.35, -0.937, 0.62, 0.80, 0.42},   // mesiobuccal
                                  {-0.75, 2.90, 6.85, 0.05, -0.999, 0.66, 0.85, 0.52},   // distobuccal
                                  {-3.45, 2.15, 6.35, 0.60, -0.800, 0.50, 0.75, 0.50},   // distal
                                  {3.15, -2.72, 7.50, -0.55, 0.835, 0.74, 0.95, 0.52},   // mesiolingual
                                  {-3.05, -2.85, 7.25, 0.55, 0.835, 0.72, 0.95, 0.52}};  // distolingual

const std::vector<OcclusalRidge> kMarginalRidges = {{3.70, 1.0, 3.75, -1.1, 6.05, 0.60},
                                                    {-3.50, 0.9, -3.40, -1.2, 5.85, 0.60}};

// The central groove winds from the mesial to the distal pit through one bowl, deepest in the middle. The buccal and
// the distobuccal groove leave it to the cheek, the lingual one opposite to their middle: a Y.
const std::vector<OcclusalGroove> kGrooves = {
    {2.85, 0.10, 1.90, -0.20, 0.24, 0.36, 0.30},    {1.90, -0.20, 0.90, 0.05, 0.30, 0.38, 0.34},
    {0.90, 0.05, -0.20, -0.21, 0.34, 0.40, 0.42},   {-0.20, -0.21, -1.15, 0.20, 0.42, 0.40, 0.36},
    {-1.15, 0.20, -1.90, 0.35, 0.36, 0.38, 0.32},   {-1.90, 0.35, -2.70, -0.10, 0.32, 0.36, 0.24},
    {-0.20, -0.21, -0.10, 0.63, 0.42, 0.40, 0.38},  {-0.10, 0.63, 0.00, 1.36, 0.38, 0.40, 0.34},
    {0.00, 1.36, 0.50, 1.99, 0.34, 0.40, 0.32},     {0.50, 1.99, 0.62, 2.90, 0.32, 0.42, 0.36},
    {0.62, 2.90, 0.66, 4.8, 0.36, 0.44, 0.40},      {-1.90, 0.35, -2.25, 1.40, 0.32, 0.36, 0.24},
    {-2.25, 1.40, -2.45, 2.70, 0.24, 0.36, 0.22},   {-2.45, 2.70, -2.60, 4.2, 0.22, 0.40, 0.26},
    {-0.20, -0.21, 0.00, -1.04, 0.42, 0.40, 0.34},  {0.00, -1.04, 0.22, -1.99, 0.34, 0.40, 0.30},
    {0.22, -1.99, 0.10, -2.93, 0.30, 0.40, 0.30},   {0.10, -2.93, 0.14, -4.9, 0.30, 0.44, 0.34},
    {2.85, 0.10, 3.30, 1.10, 0.24, 0.32, 0.05},     {2.85, 0.10, 3.35, -0.75, 0.18, 0.30, 0.04},
    {-2.70, -0.10, -3.15, -1.05, 0.22, 0.32, 0.05}, {1.90, -0.20, 2.35, -1.35, 0.16, 0.28, 0.03},
    {-1.15, 0.20, -1.55, 1.50, 0.12, 0.28, 0.03}};

const std::vector<OcclusalPit> kPits = {
    {-0.20, -0.21, 0.16, 0.44}, {2.85, 0.10, 0.10, 0.36}, {-2.70, -0.10, 0.10, 0.36}};

// Tips and flanks of the cusps, their triangular ridges, grooves, and marginal ridges. Where the measured teeth are
// worn, the buccal cusps, they stand between these and the textbook.
const std::vector<OcclusalLandmark> kLandmarks = {
    // tips
    {2.00, 2.30, 0.52},
    {-0.75, 2.90, 0.65},
    {-3.40, 2.15, 1.12},
    {3.18, -2.72, 0.00},
    {-3.10, -2.85, 0.27},
    // flanks
    {2.25, 3.40, 1.05},
    {-0.75, 3.90, 1.20},
    {-3.90, 3.00, 1.75},
    {3.20, -3.75, 0.78},
    {-3.05, -3.80, 0.95},
    // triangular ridges
    {1.70, 1.75, 0.82},
    {1.30, 1.10, 1.35},
    {-0.80, 2.10, 0.92},
    {-0.90, 1.35, 1.40},
    {-3.00, 1.40, 1.40},
    {2.40, -2.18, 0.36},
    {1.80, -1.63, 0.95},
    {1.20, -1.09, 1.58},
    {-2.32, -2.34, 0.52},
    {-1.74, -1.76, 1.10},
    {-1.16, -1.17, 1.75},
    // central groove and pit
    {2.85, 0.10, 1.75},
    {1.90, -0.20, 1.95},
    {0.90, 0.05, 2.22},
    {-0.20, -0.21, 2.52},
    {-1.15, 0.20, 2.32},
    {-1.90, 0.35, 2.12},
    {-2.70, -0.10, 1.88},
    // buccal, distobuccal and lingual groove
    {-0.10, 0.63, 2.24},
    {0.00, 1.36, 1.92},
    {0.50, 1.99, 1.62},
    {0.62, 2.90, 1.50},
    {-2.25, 1.40, 1.80},
    {-2.45, 2.70, 1.48},
    {0.00, -1.04, 2.06},
    {0.22, -1.99, 1.66},
    {0.10, -2.93, 1.48},
    // marginal ridges and their outer slopes
    {3.30, 1.45, 1.05},
    {3.72, 0.30, 1.47},
    {3.75, -0.85, 1.25},
    {3.55, -1.90, 0.62},
    {4.85, 0.20, 1.95},
    {-3.60, 1.10, 1.50},
    {-3.35, 0.00, 1.67},
    {-3.45, -1.15, 1.35},
    {-3.30, -2.10, 0.68},
    {-4.75, 0.00, 2.05}};

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

PosteriorToothPlan lowerFirstMolar() {
    PosteriorToothPlan plan;
    plan.name = "Lower right first molar";
    plan.fdi = 46;
    plan.bounds = Box3(Vec3(-6.5, -6.5, -14.8), Vec3(6.5, 6.5, 8.2));
    plan.crown = kCrown;
    plan.lingualRise = 1.4;
    plan.narrowsLingually = 0.016;
    plan.narrowsDistally = 0.008;
    plan.cusps = kCusps;
    plan.ridges = kMarginalRidges;
    plan.grooves = kGrooves;
    plan.pits = kPits;
    plan.top = 7.5;
    plan.landmarks = kLandmarks;
    plan.outline = kOutline;
    plan.developmentalGrooves = {{true, 0.66, 0.38, 0.55}, {true, -2.60, 0.26, 0.5}, {false, 0.14, 0.30, 0.6}};
    plan.trunkEnd = -3.7;
    plan.roots = {{kMesialRoot, -14.05, 0.6, 0}, {kDistalRoot, -13.25, 0.35, 0}};
    // Between z = -0.45 and 1.1: 6.4 mm and 8 mm below the highest cusp.
    plan.chamber = Vec3(-0.1, 0, 0.33);
    plan.chamberHalf = Vec3(2.40, 1.95, 0.78);
    plan.canals = {kMesiobuccalCanal, kMesiolingualCanal, kDistalCanal};
    return plan;
}

}  // namespace tactooth
