// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Measured on CT scans of the teeth of two adults and of three extracted upper first molars. Lengths in mm in the frame
// of a BuiltinTooth with +x mesial. Some of these teeth are worn.
#pragma once

#include <array>

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
