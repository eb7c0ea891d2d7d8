// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Measured on CT scans of the teeth of two adults and of three extracted upper first molars. Lengths in mm in the frame
// of a BuiltinTooth with +x mesial. Some of these teeth are worn.
#pragma once

#include <array>
#include <vector>

#include "geometry/util/vec.h"

namespace tactooth::test {

/// A horizontal section of a crown.
struct MeasuredSection {
    double mesiodistal, buccolingual;  ///< 0: through the tips of a back tooth, not compared
};

inline constexpr std::array<double, 5> kSectionDepths = {0.10, 0.25, 0.50, 0.75, 0.90};  // shares of the crown's length

/// Sections of a crown at these depths below its highest point, with its largest diameters.
struct MeasuredCrown {
    int fdi;
    double mesiodistal, buccolingual;
    std::array<MeasuredSection, 5> sections;
};

inline constexpr std::array<MeasuredCrown, 14> kMeasuredCrowns = {
    {{11, 8.15, 7.70, {{{7.6, 2.6}, {8.1, 3.7}, {7.9, 5.8}, {6.7, 7.6}, {5.6, 7.2}}}},
     {12, 7.00, 6.80, {{{5.9, 2.0}, {6.8, 3.0}, {6.7, 4.7}, {5.7, 6.6}, {4.9, 7.0}}}},
     {13, 7.30, 8.10, {{{4.3, 2.5}, {6.5, 4.0}, {7.2, 7.3}, {5.9, 8.0}, {5.1, 7.4}}}},
     {14, 6.15, 9.25, {{{0, 0}, {5.4, 8.2}, {6.0, 9.1}, {4.7, 8.6}, {4.1, 7.9}}}},
     {15, 5.95, 9.05, {{{0, 0}, {5.6, 8.4}, {5.6, 8.9}, {4.4, 8.2}, {4.2, 7.7}}}},
     {16, 9.62, 10.74, {{{0, 0}, {8.7, 8.6}, {9.5, 10.5}, {8.4, 10.5}, {7.6, 10.3}}}},
     {17, 9.10, 10.00, {{{0, 0}, {8.4, 8.6}, {9.1, 9.6}, {8.2, 10.0}, {7.3, 9.6}}}},
     {41, 4.70, 6.10, {{{4.4, 1.9}, {4.6, 2.8}, {4.4, 4.5}, {3.7, 6.1}, {3.4, 5.7}}}},
     {42, 5.57, 6.13, {{{5.2, 1.8}, {5.5, 2.6}, {5.1, 4.2}, {4.1, 6.0}, {3.7, 5.8}}}},
     {43, 6.27, 7.23, {{{4.2, 2.1}, {6.1, 3.7}, {5.9, 6.1}, {4.9, 7.0}, {4.6, 6.8}}}},
     {44, 6.43, 7.67, {{{0, 0}, {6.1, 4.3}, {6.1, 7.4}, {5.0, 7.1}, {4.5, 6.4}}}},
     {45, 7.00, 8.57, {{{0, 0}, {6.6, 7.8}, {6.7, 8.2}, {5.4, 7.5}, {4.8, 7.0}}}},
     {46, 10.90, 10.05, {{{0, 0}, {10.1, 9.3}, {10.5, 9.8}, {9.5, 9.3}, {8.7, 8.7}}}},
     {47, 10.15, 9.25, {{{0, 0}, {9.6, 8.2}, {10.0, 9.0}, {9.2, 9.0}, {8.7, 8.7}}}}}};

/// A harmonic of an outline: the coefficients of cos m t and sin m t, mm, with t from mesial to buccal.
struct Harmonic {
    double cosine, sine;
};

/// The outline from above of the upper 80 % of a crown: distances from the middle of its box.
struct MeasuredOutline {
    int fdi;
    double mean;                        ///< mm
    std::array<Harmonic, 6> harmonics;  ///< of order 1 to 6
};

inline constexpr std::array<MeasuredOutline, 14> kMeasuredOutlines = {
    {{11, 3.89, {{{.00, .23}, {.03, .07}, {.01, .29}, {-.03, -.05}, {-.02, .03}, {-.02, -.01}}}},
     {12, 3.42, {{{.08, .07}, {-.02, -.05}, {-.04, .11}, {-.02, -.03}, {.03, .04}, {.02, .00}}}},
     {13, 3.74, {{{.07, .15}, {-.19, .10}, {-.09, .12}, {.07, .04}, {-.02, -.01}, {-.02, -.02}}}},
     {14, 3.79, {{{-.02, .07}, {-.81, -.05}, {.03, .08}, {.03, .06}, {-.02, -.01}, {.00, .00}}}},
     {15, 3.65, {{{-.01, .03}, {-.79, .00}, {-.01, .01}, {.06, .04}, {-.01, -.02}, {.01, -.01}}}},
     {16, 5.11, {{{-.03, .05}, {-.32, .32}, {-.05, .12}, {-.19, .00}, {.06, .03}, {-.01, .00}}}},
     {17, 4.71, {{{-.08, .23}, {-.23, .23}, {-.13, .26}, {-.06, .02}, {.11, -.03}, {-.04, -.01}}}},
     {41, 2.62, {{{.01, .15}, {-.40, -.01}, {.02, .13}, {.05, .00}, {-.01, -.04}, {.01, .01}}}},
     {42, 2.80, {{{.02, .15}, {-.20, -.06}, {-.02, .14}, {.07, .00}, {.00, .02}, {.03, .01}}}},
     {43, 3.23, {{{-.03, .11}, {-.26, .20}, {-.01, .09}, {.10, .01}, {-.02, .00}, {.02, .00}}}},
     {44, 3.45, {{{.02, .05}, {-.32, .01}, {.01, .05}, {.05, -.01}, {-.01, .02}, {.00, -.02}}}},
     {45, 3.89, {{{.02, -.19}, {-.39, -.01}, {-.04, -.11}, {-.02, .01}, {.01, .08}, {-.01, .00}}}},
     {46, 5.35, {{{.14, -.02}, {.14, .04}, {-.14, .00}, {-.23, .01}, {-.07, .05}, {-.04, .00}}}},
     {47, 4.98, {{{.11, -.09}, {.24, .02}, {-.14, -.08}, {-.22, -.03}, {.00, -.02}, {.00, .01}}}}}};

/// A place of an occlusal surface: x, y, and the depth below the highest cusp.
using OcclusalPlace = Vec3;

/// The occlusal surface of a back tooth: means of the teeth that show the place unworn.
struct MeasuredTable {
    int fdi;
    double mesiodistal, buccolingual;        ///< largest diameters of these teeth
    std::vector<OcclusalPlace> tips;         ///< of cusps
    std::vector<OcclusalPlace> places = {};  ///< of ridges, grooves and pits
};

inline const std::array<MeasuredTable, 8> kMeasuredTables = {
    {{14, 6.15, 9.25, {{-.05, 2.3, 0}, {.2, -2.3, .60}}},
     {15, 5.95, 9.05, {{.15, 2.35, 0}, {.55, -2.05, .39}}},
     // Three extracted teeth; the distolingual cusp and the distal pit of the two that are sound there.
     {16,
      9.90,
      10.83,
      {{2.37, 3.40, .09}, {-2.17, 2.47, .68}, {1.0, -3.1, 0}, {-2.45, -3.05, .81}},
      {// buccal groove and central pit
       {-.45, 3.45, 1.39},
       {-.15, 2.10, 1.85},
       {.00, 1.43, 2.30},
       {.20, .80, 2.63},
       // distolingual groove and distal pit
       {-1.80, -3.10, .95},
       {-1.90, -2.35, 1.22},
       {-2.00, -1.65, 1.60},
       {-2.25, -1.00, 1.93},
       {-2.60, -.40, 2.22},
       // oblique ridge
       {.23, -2.00, .35},
       {-.57, -1.17, .80},
       {-1.40, -.10, 1.60},
       {-1.70, 1.13, 1.23},
       // central to mesial
       {1.10, .20, 2.22},
       {1.90, .15, 1.90},
       {3.43, .10, 1.57},
       // triangular ridges
       {1.90, 2.72, .38},
       {1.42, 2.04, .93},
       {.95, 1.36, 1.75},
       {.60, -1.86, .38},
       {.40, -1.24, .72},
       {.00, .00, 1.81}}},
     // Heights of worn cusps are not those of a sound tooth: one adult's other side stands for them.
     {17, 9.10, 10.00, {{2.0, 2.7, .40}, {-2.4, 2.3, .72}, {.8, -2.4, 0}}},
     {44, 6.43, 7.67, {{.03, .9, 0}, {.45, -2.95, 2.28}}},
     {45, 7.00, 8.57, {{.2, 1.47, 0}, {1.5, -2.6, .67}, {-1.65, -2.55, 1.36}}},
     {46,
      10.95,
      10.05,
      {{2.1, 2.2, .60}, {3.0, -2.6, 0}, {-2.9, -2.8, .30}},
      {// buccal groove and central pit
       {.50, 1.90, 1.54},
       {.00, 1.30, 1.84},
       {-.10, .60, 2.16},
       {-.20, -.20, 2.42},
       // lingual groove
       {.10, -2.80, 1.60},
       {.20, -1.90, 1.60},
       {.00, -1.00, 2.02},
       // marginal ridges and the valley between them
       {3.70, .30, 1.49},
       {-3.30, .00, 1.69}}},
     {47,
      10.15,
      9.25,
      {{2.2, 2.0, .48}, {-2.5, 2.7, .77}, {2.85, -2.5, 0}, {-2.35, -2.5, .19}},
      {{-.40, 2.60, 1.06},
       {-.50, 1.40, 1.40},
       {-.50, .90, 1.70},
       {-.60, .30, 1.86},
       {.10, -1.10, 1.59},
       {.00, -.30, 1.76},
       {2.50, .10, 1.20},
       {-3.20, .30, 1.36}}}}};

inline constexpr std::array<double, 8> kProfileDepths = {0.5, 1, 2, 3, 4, 5, 6, 7};  // mm below the edge in the midline

/// The edge of a front tooth, and the profile in its midline.
struct MeasuredEdge {
    int fdi;
    std::array<Vec3, 7> edge;           ///< distal to mesial; z: mm below the highest point of the edge
    std::array<double, 8> lip, tongue;  ///< y of the labial and of the lingual side at the depths of the profile
};

inline const std::array<MeasuredEdge, 6> kMeasuredEdges = {{{11,
                                                             {{{-3.4, 1.0, .55},
                                                               {-2.3, 1.2, .14},
                                                               {-1.2, 1.4, .07},
                                                               {0, 1.4, .03},
                                                               {1.1, 1.4, .16},
                                                               {2.3, 1.3, .25},
                                                               {3.4, 1.05, .37}}},
                                                             {2.4, 2.7, 3.1, 3.3, 3.5, 3.8, 3.9, 4.0},
                                                             {.5, .3, .1, .0, -.6, -1.6, -2.5, -3.3}},
                                                            {12,
                                                             {{{-2.9, 1.2, 1.1},
                                                               {-2.0, 1.35, .46},
                                                               {-1.0, 1.4, .17},
                                                               {0, 1.4, .05},
                                                               {.95, 1.3, 0},
                                                               {1.9, 1.25, .07},
                                                               {2.9, 1.3, .33}}},
                                                             {2.3, 2.5, 2.8, 3.0, 3.4, 3.8, 4.0, 4.0},
                                                             {.6, .4, .1, -.2, -.7, -1.4, -2.2, -2.8}},
                                                            {13,
                                                             {{{-3.1, .75, 2.2},
                                                               {-2.1, 1.0, .96},
                                                               {-1.1, 1.1, .15},
                                                               {-.1, 1.1, 0},
                                                               {.9, 1.1, .21},
                                                               {2.0, 1.2, .71},
                                                               {3.0, 1.2, 1.6}}},
                                                             {2.1, 2.4, 2.9, 3.4, 3.8, 4.1, 4.2, 4.2},
                                                             {.1, -.2, -.7, -1.2, -2.2, -3.2, -3.7, -3.8}},
                                                            {41,
                                                             {{{-2.0, .4, .35},
                                                               {-1.3, .43, .1},
                                                               {-.65, .52, .09},
                                                               {0, .55, .1},
                                                               {.65, .52, .1},
                                                               {1.3, .45, .08},
                                                               {1.95, .44, .3}}},
                                                             {1.4, 1.6, 2.2, 2.6, 2.9, 3.1, 3.3, 3.3},
                                                             {-.2, -.3, -.4, -.7, -1.3, -2.0, -2.6, -2.8}},
                                                            {42,
                                                             {{{-2.35, .46, .54},
                                                               {-1.6, .45, .07},
                                                               {-.85, .5, 0},
                                                               {-.1, .53, .04},
                                                               {.7, .55, .1},
                                                               {1.45, .56, .17},
                                                               {2.2, .57, .33}}},
                                                             {1.3, 1.6, 2.0, 2.3, 2.6, 2.9, 3.1, 3.3},
                                                             {-.2, -.3, -.4, -.6, -1.0, -1.7, -2.4, -2.8}},
                                                            {43,
                                                             {{{-2.7, .35, 1.8},
                                                               {-1.8, .69, .92},
                                                               {-.9, .8, .34},
                                                               {0, .78, .12},
                                                               {.8, .83, .14},
                                                               {1.7, .85, .47},
                                                               {2.6, .82, 1.1}}},
                                                             {1.7, 2.0, 2.5, 2.9, 3.2, 3.4, 3.6, 3.7},
                                                             {.1, .0, -.4, -.8, -1.5, -2.2, -2.8, -2.9}}}};

}  // namespace tactooth::test
