// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Outlines of crowns, roots and canals from the few lengths that textbook tables give.
#pragma once

#include <vector>

#include "instruments/modelling/section_loft.h"

namespace tactooth {

/// The sides of a crown, mm. Mesial and distal are the two signs of x, buccal and lingual those of y.
struct CrownForm {
    double length = 7;                           ///< from the cervical line to the highest cusp
    double mesiodistal = 10, buccolingual = 10;  ///< largest diameters
    double cervixMesiodistal = 8, cervixBuccolingual = 9;
    double mesialContact = 0.67, distalContact = 0.6;  ///< heights of the widest points, as shares of the length
    double buccalCrest = 0.3, lingualCrest = 0.5;
    double mesialTop = 0.86, distalTop = 0.84;  ///< half widths above the cusps, as shares of the largest ones
    double buccalTop = 0.62, lingualTop = 0.7;
    double buccalShift = 0;  ///< mm that the widest point is shifted to buccal from the neck
    double flare = 1;        ///< above 1: stays narrow over a longer part above the neck
    double cervixSquareness = 2.5, topSquareness = 2.3;
    double trunkNarrowing = 0.66;  ///< share of the neck's half widths, 4.2 mm below it
};

[[nodiscard]] std::vector<Section> crownSections(const CrownForm& form);

/// A root: its centre line bends from the neck by `bend` to the apex.
struct RootForm {
    double length = 13;
    double cervixX = 0, cervixY = 0;  ///< its middle at the neck
    double bendX = 0, bendY = 0;      ///< displacement of the middle of the centre line
    double apexX = 0, apexY = 0;
    double halfMesiodistal = 2, halfBuccolingual = 3;  ///< at the neck
    double squareness = 2.3;
    double fullness = 1;  ///< above 1: stays thick over a longer part
};

[[nodiscard]] std::vector<Section> rootSections(const RootForm& form);

/// A canal along the middle of a root, `aside` mm to buccal of it at half its length, which widens to these half widths
/// at the chamber.
struct CanalForm {
    double aside = 0;
    double halfMesiodistal = 0.45, halfBuccolingual = 0.45;
};

[[nodiscard]] std::vector<Section> canalSections(const RootForm& root, const CanalForm& form);

}  // namespace tactooth
