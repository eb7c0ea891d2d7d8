// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/mirror.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/util/assert.h"
#include "instruments/modelling/surface_of_revolution.h"

namespace tactooth {
namespace {

constexpr double kRim = 0.75;            // mm of metal around the glass
constexpr double kGap = 0.05;            // mm between the parts: no two of their surfaces touch
constexpr double kGlassThickness = 0.8;  // mm
constexpr double kAngle = std::numbers::pi / 4;

/// A plate with a rounded rim, a recess for the glass and a slightly domed back.
TriangleMesh metalHead(double radius) {
    const double recess = radius - kRim + kGap, floor = -kGlassThickness - kGap;
    const std::vector<OutlinePoint> outline = {{0, -2.9},
                                               {0.5 * radius, -2.75},
                                               {0.8 * radius, -2.45},
                                               {radius - 0.7, -2.1},
                                               {radius - 0.25, -1.75},
                                               {radius, -1.2},
                                               {radius, -0.3},
                                               {radius - 0.1, 0.05},
                                               {radius - 0.3, 0.2},
                                               {recess + 0.15, 0.2},
                                               {recess, 0.1},
                                               {recess, floor},
                                               {0, floor}};
    constexpr int kSides = 96;
    return revolved(outline, kSides);
}

TriangleMesh glassPlate(double radius) {
    const std::vector<OutlinePoint> outline = {{0, -kGlassThickness}, {radius, -kGlassThickness}, {radius, 0}, {0, 0}};
    constexpr int kSides = 96;
    return revolved(outline, kSides);
}

/// Stem, socket and handle along +z, from the end at the head.
TriangleMesh stemAndHandle() {
    std::vector<OutlinePoint> outline = {{0, 0},      {0.7, 0.12}, {1.15, 0.5}, {1.3, 1.1},  {1.15, 2.0}, {1.0, 3.2},
                                         {1.0, 17.0}, {1.2, 20.0}, {1.6, 22.0}, {2.3, 23.2}, {2.7, 23.8}, {2.8, 25.4},
                                         {2.4, 25.8}, {2.4, 26.4}, {2.8, 26.8}, {3.0, 28.0}, {3.0, 36.0}};
    constexpr double kFirstGroove = 38, kLastGroove = 68, kSpacing = 1.5, kDepth = 0.25;  // rings for the fingers
    for (double z = kFirstGroove; z <= kLastGroove; z += kSpacing) {
        outline.insert(outline.end(),
                       {{3.0, z - 0.4}, {3.0 - kDepth, z - 0.2}, {3.0 - kDepth, z + 0.2}, {3.0, z + 0.4}});
    }
    outline.insert(outline.end(),
                   {{3.0, 90}, {2.9, 130}, {3.0, 141}, {2.95, 143}, {2.6, 144.2}, {1.8, 144.8}, {0, 145}});
    constexpr int kSides = 36;
    return revolved(outline, kSides);
}

/// Pose of the stem: its end is beside the lower edge of the head, and its axis rises behind the glass.
Pose stemInMirror(double radius) {
    const Quat turn(Eigen::AngleAxisd(std::numbers::pi - kAngle, Vec3::UnitY()));
    constexpr double kAside = 0.42, kHeight = -0.80;  // mm; the round end of the stem does not touch the rim
    return {Vec3(radius + kAside, 0, kHeight), turn};
}

}  // namespace

DentalMirror makeMirror(double headDiameter) {
    TACTOOTH_ASSERT(headDiameter >= kSmallestMirror && headDiameter <= kLargestMirror);
    const double radius = headDiameter / 2;
    DentalMirror mirror;
    mirror.surface = metalHead(radius);
    append(mirror.surface, transformed(stemAndHandle(), stemInMirror(radius)));
    mirror.glassBegin = mirror.surface.triangles.size();
    mirror.disc = {Vec3::Zero(), Vec3::UnitZ(), radius - kRim};
    append(mirror.surface, glassPlate(mirror.disc.radius));
    return mirror;
}

double mirrorHeadOf(double discRadius) { return 2 * (discRadius + kRim); }

}  // namespace tactooth
