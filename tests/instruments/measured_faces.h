// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// What the same CT scans as in measured_teeth.h show of the sides of crowns, their lingual fossae and their enamel; mm.
#pragma once

#include <array>

namespace tactooth::test {

/// Depth of the widest place of a side below the highest point of the crown: from the least to the greatest of the
/// teeth, or their mean alone.
struct MeasuredContour {
    double least, greatest;
};

struct MeasuredContours {
    int fdi;
    MeasuredContour mesial, distal, buccal, lingual;  ///< buccal and lingual of front teeth: in the cervical third
};

inline constexpr std::array<MeasuredContours, 14> kMeasuredContours = {
    {{11, {1.4, 3.6}, {2.6, 3.4}, {7.1, 7.1}, {8.2, 8.2}},
     {12, {1.8, 1.8}, {3.4, 4.1}, {6.7, 6.7}, {7.2, 7.2}},
     {13, {3.9, 3.9}, {4.5, 5.8}, {6.1, 6.9}, {6.5, 7.5}},
     {14, {3.5, 3.5}, {4.1, 4.7}, {4.5, 4.5}, {5.2, 5.2}},
     {15, {2.0, 3.6}, {2.8, 4.3}, {4.8, 4.8}, {2.9, 4.8}},
     {16, {2.8, 3.6}, {2.9, 4.1}, {4.5, 5.9}, {3.8, 5.5}},
     {17, {3.2, 3.2}, {3.5, 3.5}, {5.3, 5.3}, {4.7, 4.7}},
     {41, {1.5, 3.5}, {2.0, 3.2}, {6.5, 6.5}, {7.0, 7.0}},
     {42, {1.5, 2.3}, {1.4, 3.9}, {7.3, 7.3}, {7.4, 7.4}},
     {43, {3.4, 3.4}, {3.6, 4.3}, {6.8, 8.7}, {6.9, 8.7}},
     {44, {3.1, 3.1}, {2.9, 2.9}, {5.0, 6.6}, {4.0, 4.0}},
     {45, {3.1, 3.1}, {2.9, 2.9}, {4.5, 5.3}, {2.1, 3.9}},
     {46, {3.4, 3.4}, {3.2, 3.2}, {5.5, 5.5}, {3.2, 3.2}},
     {47, {2.7, 2.7}, {3.3, 3.3}, {5.1, 5.1}, {3.4, 3.4}}}};

inline constexpr std::array<double, 4> kFossaDepths = {0.35, 0.45, 0.55, 0.65};  // shares of the crown's length

/// The lingual fossa of a front tooth.
struct MeasuredFossa {
    int fdi;
    std::array<double, 4> depth;  ///< below the crests beside it, at these shares of the crown below the edge
    double profile;               ///< below the line from edge to cingulum, in the midline
};

inline constexpr std::array<MeasuredFossa, 6> kMeasuredFossae = {{{11, {.45, .20, .10, 0}, .82},
                                                                  {12, {.15, .25, .10, 0}, .50},
                                                                  {13, {.20, .12, .03, 0}, .20},
                                                                  {41, {.02, 0, 0, 0}, .47},
                                                                  {42, {.03, 0, 0, 0}, .59},
                                                                  {43, {.18, .02, 0, 0}, .25}}};

inline constexpr std::array<double, 3> kEnamelHeights = {1 / 3.0, 0.5, 0.75};  // from the cervical line to the top

/// Thickness of the enamel in the middle of the sides at these heights, and where it is thickest: over cusps or edge.
struct MeasuredEnamel {
    int fdi;
    std::array<double, 3> buccal, lingual;
};

inline constexpr std::array<MeasuredEnamel, 7> kMeasuredEnamel = {{{42, {.49, .70, .90}, {.36, .41, .56}},
                                                                   {43, {.56, .76, .98}, {.40, .48, .58}},
                                                                   {44, {.58, .97, 1.22}, {.65, .92, 1.05}},
                                                                   {45, {.64, 1.07, 1.48}, {.59, .87, 1.23}},
                                                                   {46, {.63, 1.05, 1.75}, {.67, .94, 1.32}},
                                                                   {47, {.62, .98, 1.72}, {.61, .89, 1.31}},
                                                                   {16, {.46, 1.04, 1.46}, {.80, 1.19, 1.84}}}};

}  // namespace tactooth::test
