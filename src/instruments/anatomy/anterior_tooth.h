// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "instruments/anatomy/tooth_shape.h"
#include "instruments/modelling/section_loft.h"

namespace tactooth {

/// A shallow vertical groove in the labial or lingual face; a negative depth is a ridge.
struct FaceGroove {
    double x = 0, width = 1;  ///< its middle, and half its width
    double from = 0, to = 0;  ///< heights between which it is deepest
    double depth = 0;
};

/// The parameters of one anterior tooth; mm.
struct AnteriorToothPlan {
    std::string name;
    int fdi = 0;
    std::vector<Section> body;    ///< from the apex to above the edge; a lingual face in front of the axis is negative
    double apex = 0;              ///< height of the root's end
    double edgeX = 0, edgeZ = 0;  ///< highest point of the incisal edge
    double mesialEdgeSlope = 0, distalEdgeSlope = 0;  ///< slopes of the edge away from it
    double edgeRoundness = 0.2;                       ///< length over which the two slopes meet
    double bevel = 0.3;                               ///< slope of the edge toward the tongue
    std::vector<FaceGroove> labial = {}, lingual = {};
    double mesialRise = 0, distalRise = 0;  ///< of the cervical line at the proximal sides
    double cervicalHalfWidth = 3;
    double enamelThickness = 1;  ///< at the labial and lingual face
    /// Thickness perpendicular to the edge's slope; the core ends before it becomes too thin.
    double incisalEnamel = 2;
    std::vector<Section> pulp;      ///< from the end of the canal to the horns
    Vec3 lesionFrom, lesionToward;  ///< a line from inside the tooth to the lesion's opening in the surface
};

/// The lengths of an anterior tooth that textbook tables give, mm.
struct AnteriorToothSize {
    double crown = 10, root = 13;
    double mesiodistal = 8, cervixMesiodistal = 6, labiolingual = 7, cervixLabiolingual = 6;
};

/// The same tooth in another size, with another name and number: each length in proportion, neck and crown separately.
/// All lengths are positive.
[[nodiscard]] AnteriorToothPlan resized(AnteriorToothPlan plan, const AnteriorToothSize& from,
                                        const AnteriorToothSize& to, std::string name, int fdi);

/// Shifts the centre of each section along x, by `shift(z)` mm toward mesial.
template <class Shift>
void shiftCentres(std::vector<Section>& sections, const Shift& shift) {
    for (Section& section : sections) section.x += shift(section.z);
}

/// The tooth of a plan.
[[nodiscard]] ToothShape anteriorTooth(const AnteriorToothPlan& plan);

}  // namespace tactooth
