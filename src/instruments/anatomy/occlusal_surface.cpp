// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/anatomy/occlusal_surface.h"

#include <algorithm>
#include <cmath>

#include "instruments/modelling/blend.h"

namespace tactooth {
namespace {

double distanceToSegment(double x, double y, double ax, double ay, double bx, double by) {
    const double dx = bx - ax, dy = by - ay;
    const double part = std::clamp(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(x - ax - part * dx, y - ay - part * dy);
}

/// |x| without its kink: ridges are rounded.
double softened(double x) {
    constexpr double kRound = 0.18;  // mm
    return std::sqrt(x * x + kRound * kRound) - kRound;
}

double cuspHeight(const Cusp& cusp, double tip, double x, double y) {
    const double dx = x - cusp.x, dy = y - cusp.y;
    const double in = dx * cusp.inX + dy * cusp.inY, beside = dx * cusp.inY - dy * cusp.inX;
    const double a = softened(in) * (in > 0 ? cusp.inward : cusp.outward), b = softened(beside) * cusp.along;
    constexpr double kPyramid = 1.3;  // 1: four sharp ridges, 2: a round cone
    const double drop = std::pow(std::pow(a, kPyramid) + std::pow(b, kPyramid), 1 / kPyramid);
    return cusp.z - std::sqrt(drop * drop + tip * tip) + tip;
}

}  // namespace

double occlusalHeight(const BackToothPlan& plan, double x, double y) {
    constexpr double kBlend = 0.55;      // mm, over which slopes run into each other
    constexpr double kRidgeRound = 0.4;  // mm, of a ridge's crest
    double height = plan.fossa;
    for (const Cusp& cusp : plan.cusps) height = -smoothUnion(-height, -cuspHeight(cusp, plan.tip, x, y), kBlend);
    for (const OcclusalRidge& ridge : plan.ridges) {
        const double away = distanceToSegment(x, y, ridge.ax, ridge.ay, ridge.bx, ridge.by);
        const double ridgeHeight = ridge.z - ridge.slope * (std::hypot(away, kRidgeRound) - kRidgeRound);
        height = -smoothUnion(-height, -ridgeHeight, kBlend);
    }
    return height;
}

double grooveDepth(const BackToothPlan& plan, double x, double y) {
    double deepest = 0;
    for (const OcclusalGroove& g : plan.grooves) {
        deepest = std::max(deepest, g.depth * bump(distanceToSegment(x, y, g.ax, g.ay, g.bx, g.by), g.width));
    }
    for (const OcclusalPit& pit : plan.pits) deepest += pit.depth * bump(std::hypot(x - pit.x, y - pit.y), pit.width);
    return deepest;
}

}  // namespace tactooth
