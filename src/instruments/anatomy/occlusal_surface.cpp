// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/anatomy/occlusal_surface.h"

#include <algorithm>
#include <cmath>

#include "instruments/modelling/blend.h"

namespace tactooth {
namespace {

/// The nearest place of a line: how far along it, and its squared distance.
struct Nearest {
    double part, square;
};
Nearest nearestOnSegment(double x, double y, double ax, double ay, double bx, double by) {
    const double dx = bx - ax, dy = by - ay;
    const double part = std::clamp(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    const double fromX = x - ax - part * dx, fromY = y - ay - part * dy;
    return {part, fromX * fromX + fromY * fromY};
}

/// |x| without its kink: ridges are rounded.
double softened(double x) {
    constexpr double kRound = 0.18;  // mm
    return std::sqrt(x * x + kRound * kRound) - kRound;
}

/// Height of a cusp at (x, y). A result below `least` need not be exact.
double cuspHeight(const Cusp& cusp, double tip, double x, double y, double least) {
    const double dx = x - cusp.x, dy = y - cusp.y;
    const double in = dx * cusp.inX + dy * cusp.inY, beside = dx * cusp.inY - dy * cusp.inX;
    const double a = softened(in) * (in > 0 ? cusp.inward : cusp.outward), b = softened(beside) * cusp.along;
    const double leastDrop = std::max(a, b), highest = cusp.z - std::sqrt(leastDrop * leastDrop + tip * tip) + tip;
    if (highest < least) return highest;
    constexpr double kPyramid = 1.3;  // 1: four sharp ridges, 2: a round cone
    const double drop = std::pow(std::pow(a, kPyramid) + std::pow(b, kPyramid), 1 / kPyramid);
    return cusp.z - std::sqrt(drop * drop + tip * tip) + tip;
}

}  // namespace

double occlusalHeight(const PosteriorToothPlan& plan, double x, double y) {
    constexpr double kBlend = 0.55;      // mm, over which slopes blend
    constexpr double kRidgeRound = 0.4;  // mm, of a ridge's crest
    double height = plan.fossa;
    for (const Cusp& cusp : plan.cusps) {
        height = -smoothUnion(-height, -cuspHeight(cusp, plan.tip, x, y, height - kBlend), kBlend);
    }
    for (const OcclusalRidge& ridge : plan.ridges) {
        const double away = nearestOnSegment(x, y, ridge.ax, ridge.ay, ridge.bx, ridge.by).square;
        const double ridgeHeight = ridge.z - ridge.slope * (std::sqrt(away + kRidgeRound * kRidgeRound) - kRidgeRound);
        height = -smoothUnion(-height, -ridgeHeight, kBlend);
    }
    return height;
}

double grooveDepth(const PosteriorToothPlan& plan, double x, double y) {
    // Squared widths from the middle of a groove, where less than a millionth of it is left.
    constexpr double kGone = 18;
    double deepest = 0;
    for (const OcclusalGroove& g : plan.grooves) {
        const auto [part, square] = nearestOnSegment(x, y, g.ax, g.ay, g.bx, g.by);
        const double widths = square / (g.width * g.width);
        if (widths < kGone) deepest = std::max(deepest, std::lerp(g.depth, g.endDepth, part) * std::exp(-widths));
    }
    for (const OcclusalPit& pit : plan.pits) {
        const double dx = x - pit.x, dy = y - pit.y, widths = (dx * dx + dy * dy) / (pit.width * pit.width);
        if (widths < kGone) deepest += pit.depth * std::exp(-widths);
    }
    return deepest;
}

}  // namespace tactooth
