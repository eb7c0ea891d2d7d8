// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "instruments/anatomy/outline_wave.h"
#include "instruments/anatomy/tooth_shape.h"
#include "instruments/modelling/section_loft.h"
#include "instruments/modelling/smooth_curve.h"

namespace tactooth {

/// A ridge along a line on the labial or lingual face; where its height is negative, a groove or fossa.
struct FaceRidge {
    struct Point {
        double x, z, height;  ///< the height is that of the ridge there
    };
    double width = 1;           ///< half of it
    std::vector<Point> points;  ///< at least two
};

/// How the crown differs from a straight stack of its sections. Arch and turn grow from the neck to the edge.
struct CrownBend {
    double mesialArch = 0, distalArch = 0;  ///< mm that the corners of the edge stand behind its middle
    double turn = 0;   ///< mm that the distal side stands behind the middle, and the mesial one before it
    double shear = 0;  ///< mm to mesial for each mm toward the lip: the lip's side mesial, the cingulum distal
    double taper = 0;  ///< share by which the labial side is wider than the middle, and the lingual one narrower
};

/// The parameters of one anterior tooth; mm.
struct AnteriorToothPlan {
    std::string name;
    int fdi = 0;
    std::vector<Section> body;  ///< from the apex to above the edge; a lingual face in front of the axis is negative
    /// How the outline of the crown departs from the ovals: a Bezier curve over the height, of which these are the
    /// control points at equal distances up to the edge. It begins with an oval at the neck. The direction of the waves
    /// is that from the section's centre, in shares of its half axes.
    std::vector<OutlineWaves> outlines;
    CrownBend bend;
    double apex = 0;                           ///< height of the root's end
    double lean = 0;                           ///< mm that the apex stands behind the neck
    double distally = 0;                       ///< mm that it stands distal of the neck
    double edgeZ = 0;                          ///< highest point of the incisal edge
    std::vector<SmoothCurve::Point> fall;      ///< of the edge below that, from distal to mesial
    double crestY = 0;                         ///< of the edge's crest in the midline
    double labialBevel = 1, lingualBevel = 1;  ///< slopes of the edge away from its crest
    double edgeRoundness = 0.6;                ///< length over which the two slopes meet
    std::vector<FaceRidge> labial = {}, lingual = {};
    double mesialRise = 0, distalRise = 0;  ///< of the cervical line at the proximal sides
    double enamelThickness = 1;             ///< at the labial face near the edge, where it is thickest
    /// Thickness perpendicular to the edge's slope; the core ends before it becomes too thin.
    double incisalEnamel = 2;
    std::vector<Section> pulp;      ///< from the end of the canal to the horns
    Vec3 lesionFrom, lesionToward;  ///< a line from inside the tooth to the lesion's opening in the surface
};

/// The tooth of a plan.
[[nodiscard]] ToothShape anteriorTooth(const AnteriorToothPlan& plan);

}  // namespace tactooth
