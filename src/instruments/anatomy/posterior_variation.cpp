// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "instruments/anatomy/cusp_variation.h"
#include "instruments/anatomy/deviation.h"
#include "instruments/anatomy/occlusal_surface.h"
#include "instruments/anatomy/occlusal_table.h"
#include "instruments/anatomy/plan_variation.h"
#include "instruments/anatomy/root_variation.h"

namespace tactooth {
namespace {

// mm. Tips of the same cusp of three upper first molars stand 0.4 to 0.9 mm from each other in height, and their
// marginal ridges up to 1 mm; some of it is size and wear.
constexpr double kCuspHeight = 0.3, kRidgeHeight = 0.25;

// mm: the displacement of a place of the table mesiodistally and buccolingually. Tips and grooves of those molars lie
// 0.3 to 0.9 mm from each other. The waves are so long that the displacement changes by less than 0.25 mm for each mm.
constexpr double kShift = 0.40, kShortestShift = 10, kLongestShift = 20;

// Shares of depth and width of grooves and pits; wavelengths in mm. Depths of the same groove differ by half.
constexpr double kGrooveDepth = 0.35, kGrooveWidth = 0.3, kShortestGroove = 5, kLongestGroove = 12;

// Shares of the depth and width of the furrows on the sides; mm for each wave of the outline. Chosen; measured outlines
// differ by 0.02 to 0.05 mm.
constexpr double kFurrowDepth = 0.35, kFurrowWidth = 0.15, kOutline = 0.03;

/// Other heights of cusps and ridges. The highest cusp keeps its height, and so the crown its length.
void varyHeights(PosteriorToothPlan& plan, std::mt19937& random) {
    std::vector<double> rises;
    double highest = -1e9, was = -1e9;
    for (const Cusp& cusp : plan.cusps) {
        rises.push_back(deviation(random, kCuspHeight));
        highest = std::max(highest, cusp.z + rises.back());
        was = std::max(was, cusp.z);
    }
    for (std::size_t i = 0; i < rises.size(); ++i) {
        Cusp& cusp = plan.cusps[i];
        const double rise = rises[i] + was - highest;
        raiseLandmarks(plan, cusp.x, cusp.y, rise);
        cusp.z += rise;
    }
    for (OcclusalRidge& ridge : plan.ridges) {
        const double rise = deviation(random, kRidgeHeight);
        raiseLandmarks(plan, ridge, rise);
        ridge.z += rise;
    }
}

/// Grooves and pits of other depth and width. Joints keep one depth.
void varyGrooves(PosteriorToothPlan& plan, std::mt19937& random) {
    const TableWave depth(random, kShortestGroove, kLongestGroove), width(random, kShortestGroove, kLongestGroove);
    for (OcclusalGroove& g : plan.grooves) {
        g.depth *= 1 + kGrooveDepth * depth(g.ax, g.ay);
        g.endDepth *= 1 + kGrooveDepth * depth(g.bx, g.by);
        g.width *= 1 + kGrooveWidth * width((g.ax + g.bx) / 2, (g.ay + g.by) / 2);
    }
    for (OcclusalPit& pit : plan.pits) {
        pit.depth *= 1 + deviation(random, kGrooveDepth);
        pit.width *= 1 + deviation(random, kGrooveWidth);
    }
    for (DevelopmentalGroove& g : plan.developmentalGrooves) {
        g.depth *= 1 + deviation(random, kFurrowDepth);
        g.width *= 1 + deviation(random, kFurrowWidth);
    }
}

/// Lowers the landmarks in a groove by what it has become deeper, so that its ridges stay where they are.
void lowerLandmarksInGrooves(PosteriorToothPlan& plan, const PosteriorToothPlan& average) {
    PosteriorToothPlan was = average, is = plan;
    was.landmarks.clear();
    is.landmarks.clear();
    const OcclusalSurface before(was), after(is);
    for (std::size_t i = 0; i < average.landmarks.size(); ++i) {
        OcclusalLandmark& place = plan.landmarks[i];
        place.depth += after.grooveDepth(place.x, place.y) - before.grooveDepth(place.x, place.y);
        place.depth = std::max(0.0, place.depth);
    }
}

/// Moves cusps, ridges, grooves, pits and landmarks together, by a smooth function of the place.
void shiftTable(PosteriorToothPlan& plan, std::mt19937& random) {
    const TableWave mesially(random, kShortestShift, kLongestShift), buccally(random, kShortestShift, kLongestShift);
    const auto shift = [&](double& x, double& y) {
        const double wasX = x, wasY = y;
        x += kShift * mesially(wasX, wasY);
        y += kShift * buccally(wasX, wasY);
    };
    for (Cusp& cusp : plan.cusps) shift(cusp.x, cusp.y);
    for (OcclusalRidge& ridge : plan.ridges) {
        shift(ridge.ax, ridge.ay);
        shift(ridge.bx, ridge.by);
    }
    for (OcclusalGroove& groove : plan.grooves) {
        shift(groove.ax, groove.ay);
        shift(groove.bx, groove.by);
    }
    for (OcclusalPit& pit : plan.pits) shift(pit.x, pit.y);
    for (OcclusalLandmark& landmark : plan.landmarks) shift(landmark.x, landmark.y);
    for (DevelopmentalGroove& groove : plan.developmentalGrooves) {
        constexpr double kSide = 4.5;  // mm: where the grooves of the table meet it
        double y = groove.buccal ? kSide : -kSide;
        shift(groove.x, y);
    }
}

}  // namespace

PosteriorToothPlan variedPlan(const PosteriorToothPlan& average, std::uint32_t seed) {
    if (seed == 0) return average;
    std::mt19937 random = planGenerator(seed, average.fdi);
    PosteriorToothPlan plan = average;
    varyCuspNumber(plan, random);
    varyHeights(plan, random);
    varyGrooves(plan, random);
    lowerLandmarksInGrooves(plan, average);
    shiftTable(plan, random);
    for (std::size_t order = 2; order < plan.outline.size(); ++order) {
        plan.outline[order].cosine += deviation(random, kOutline);
        plan.outline[order].sine += deviation(random, kOutline);
    }
    curveRoots(plan, rootSwing(seed), random);
    return plan;
}

}  // namespace tactooth
