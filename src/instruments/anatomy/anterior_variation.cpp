// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "instruments/anatomy/deviation.h"
#include "instruments/anatomy/plan_variation.h"
#include "instruments/anatomy/root_variation.h"

namespace tactooth {
namespace {

// Marginal ridges range from a trace to those of a shovel-shaped incisor. Share of the height; about the range of the
// fossae's depths on both sides of one adult.
constexpr double kRelief = 0.4;
constexpr double kFall = 0.35;     // share of the edge's fall toward each corner, chosen
constexpr double kArch = 0.3;      // share of the edge's arch, chosen
constexpr double kTurn = 0.12;     // mm: of a corner of the edge before or behind the middle, chosen
constexpr double kShear = 0.02;    // mm for each mm, chosen: that of the measured incisors is 0.03 to 0.10
constexpr double kOutline = 0.03;  // mm: of each wave of the outline, chosen: measured crowns differ by 0.02 to 0.05
// mm: the apex behind the neck, and to mesial or distal, both beside the swing of the mouth. In measured roots the lean
// is 5 to 10 degrees, in others 0.
constexpr double kLean = 0.3, kBend = 0.1;

void varyFaces(AnteriorToothPlan& plan, std::mt19937& random) {
    for (std::vector<FaceRidge>* face : {&plan.labial, &plan.lingual}) {
        for (FaceRidge& ridge : *face) {
            const double factor = 1 + deviation(random, kRelief);
            for (FaceRidge::Point& point : ridge.points) point.height *= factor;
        }
    }
}

void varyEdge(AnteriorToothPlan& plan, std::mt19937& random) {
    const double mesial = 1 + deviation(random, kFall), distal = 1 + deviation(random, kFall);
    for (SmoothCurve::Point& point : plan.fall) {
        if (point.value > 0) point.value *= point.at > 0 ? mesial : distal;
    }
    plan.bend.mesialArch *= 1 + deviation(random, kArch);
    plan.bend.distalArch *= 1 + deviation(random, kArch);
    plan.bend.turn += deviation(random, kTurn);
    plan.bend.shear += deviation(random, kShear);
}

}  // namespace

AnteriorToothPlan variedPlan(const AnteriorToothPlan& average, std::uint32_t seed) {
    if (seed == 0) return average;
    std::mt19937 random = planGenerator(seed, average.fdi);
    AnteriorToothPlan plan = average;
    varyFaces(plan, random);
    varyEdge(plan, random);
    for (OutlineWaves& waves : plan.outlines) {
        for (std::size_t order = 1; order < waves.size(); ++order) {
            waves[order].cosine += deviation(random, kOutline);
            waves[order].sine += deviation(random, kOutline);
        }
    }
    const RootSwing swing = rootSwing(seed);
    plan.lean += deviation(random, kLean) - swing.buccal;
    plan.distally += deviation(random, kBend) - swing.mesial;
    return plan;
}

}  // namespace tactooth
