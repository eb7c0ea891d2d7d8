// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <optional>
#include <vector>

#include "instruments/anatomy/outline_wave.h"
#include "instruments/anatomy/tooth_form.h"
#include "instruments/anatomy/tooth_shape.h"
#include "instruments/modelling/section_loft.h"

namespace tactooth {

/// A cusp is a rounded pyramid: ridges run from its tip inward, outward and along the row of cusps.
struct Cusp {
    double x, y, z;          // tip
    double inX, inY;         // unit, direction of its ridge toward the middle of the crown
    double inward, outward;  // slopes of those ridges
    double along;            // slope of the ridges beside them
};

/// Ridge along a straight line, with the same slope to both sides: marginal, transverse or oblique.
struct OcclusalRidge {
    double ax, ay, bx, by, z, slope;
};

/// A straight piece of a groove from a to b, at whose ends it may be of different depth.
struct OcclusalGroove {
    double ax, ay, bx, by, depth, width, endDepth = depth;
};

struct OcclusalPit {
    double x, y, depth, width;
};

/// A place that the occlusal surface, with its grooves, passes through.
struct OcclusalLandmark {
    double x, y, depth;  ///< depth: below the highest cusp
};

/// A developmental groove of the crown's buccal or lingual side, which fades toward the neck.
struct DevelopmentalGroove {
    bool buccal;
    double x, depth, width;
};

/// A tubercle on the lingual side of the crown (of Carabelli), with a crescent groove above it.
struct LingualTubercle {
    double x = 0, z = 0;  ///< its middle
    double height = 0;    ///< mm that it stands out; 0: only the groove
    double width = 1;     ///< distance from the middle at which a third of the height is left
    double groove = 0;    ///< depth of the groove
};

/// A root: outlines from its apex to within the crown.
struct RootPlan {
    std::vector<Section> sections;
    double apex = 0;            ///< height of its end
    double concavity = 0;       ///< depth of the grooves on its mesial and distal side
    double concavityY = 0;      ///< their position
    double concavityEnd = -13;  ///< height below which they have faded
};

/// The parameters of one premolar or molar; mm. +x mesial, +y buccal.
struct PosteriorToothPlan {
    std::string name;
    int fdi = 0;
    Box3 bounds;
    std::vector<Section> crown;   ///< from below the furcation to above the cusps
    double narrowsLingually = 0;  ///< share of the mesiodistal width gained for each mm to buccal
    double narrowsDistally = 0;   ///< share of the buccolingual width gained for each mm to mesial
    double skew = 0;              ///< mm that the buccal side is shifted to mesial, for each mm to buccal
    double skewFrom = -100;       ///< height at which the skew begins, so that the neck fits the root
    double fossa = 4.75;          ///< lower bound of the height of the occlusal surface
    double tip = 0.45;            ///< mm of height that rounding removes from the tip of a cusp
    std::vector<Cusp> cusps;
    std::vector<OcclusalRidge> ridges;
    std::vector<OcclusalGroove> grooves;
    std::vector<OcclusalPit> pits;            ///< fissure caries begins in the first one
    double top = 0;                           ///< height of the highest cusp, from which the landmarks are measured
    std::vector<OcclusalLandmark> landmarks;  ///< bring cusps, ridges and grooves to their heights
    OutlineWaves outline;                     ///< of the crown above its neck
    std::vector<DevelopmentalGroove> developmentalGrooves;
    std::optional<LingualTubercle> tubercle;
    double cervicalFillet = 0.9;                ///< length over which the trunk blends into the roots
    double rootTop = -0.8, rootTopRound = 1.2;  ///< where the roots end inside the trunk, and the length of the blend
    double trunkEnd = -2.9;  ///< height of the end of the common trunk of the roots; with its rounding, lower
    std::vector<RootPlan> roots;
    double mesialRise = 1.0, distalRise = 0.3,
           projection = 0.25;  ///< of the cervical line; the spur dips to the furcation
    double lingualRise = 0;    ///< height of the cervical line lingually above that buccally
    double projectionX = -0.2, cervicalHalfWidth = 4.5;
    double enamel = 1.45;       ///< thickness at the cusps
    double functionalSide = 1;  ///< side of the thicker enamel: 1 buccal (lower teeth), -1 lingual (upper teeth)
    Vec3 chamber, chamberHalf;  ///< middle and half size of the pulp chamber
    double chamberRound = 0.7;
    double hornBase = 0.62, hornRise = 5.0;  ///< radius of the pulp horns, and their distance below the cusps
    std::vector<std::vector<Section>> canals;
};

/// Adds a root with its canals. `concavity`: as in RootPlan.
void addRoot(PosteriorToothPlan& plan, const RootForm& form, std::initializer_list<CanalForm> canals,
             double concavity = 0);

[[nodiscard]] ToothShape posteriorTooth(const PosteriorToothPlan& plan);

}  // namespace tactooth
