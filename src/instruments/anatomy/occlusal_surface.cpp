// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Landmarks: interpolation by compactly supported functions, H. Wendland, Adv. Comput. Math. 4 (1995) 389. Differs: the
// sum only corrects a form of cusps, ridges and grooves, and passes the landmarks within hundredths of a mm, so that
// two near ones make no wave.
#include "instruments/anatomy/occlusal_surface.h"

#include <Eigen/Cholesky>

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

/// How much of a landmark's lift is left at a squared distance from it.
double influence(double square) {
    constexpr double kReach = 3.2;  // mm: about from cusp to cusp
    if (square >= kReach * kReach) return 0;
    const double part = std::sqrt(square) / kReach, left = (1 - part) * (1 - part);
    return left * left * (4 * part + 1);
}

double influence(const OcclusalLandmark& a, double x, double y) {
    return influence((x - a.x) * (x - a.x) + (y - a.y) * (y - a.y));
}

/// The share of a groove's depth at a distance from its middle, in widths: a crevice with a narrow bottom.
double crevice(double squareOfWidths) {
    constexpr double kSteep = 1.5, kBottom = 0.45;  // in widths: the bottom is that wide
    return std::exp(-kSteep * (std::sqrt(squareOfWidths + kBottom * kBottom) - kBottom));
}

}  // namespace

OcclusalSurface::OcclusalSurface(const PosteriorToothPlan& plan) : plan_(plan), lowest_(plan.fossa) {
    const auto count = static_cast<Eigen::Index>(plan.landmarks.size());
    if (count == 0) return;
    constexpr double kGive = 0.02;  // of the influence: landmarks need not be met exactly
    Eigen::MatrixXd influences = kGive * Eigen::MatrixXd::Identity(count, count);
    Eigen::VectorXd missing(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const OcclusalLandmark& a = plan.landmarks[static_cast<std::size_t>(i)];
        missing[i] = plan.top - a.depth - form(a.x, a.y) + grooveDepth(a.x, a.y);
        for (Eigen::Index j = 0; j < count; ++j) {
            influences(i, j) += influence(plan.landmarks[static_cast<std::size_t>(j)], a.x, a.y);
        }
    }
    lifts_ = influences.ldlt().solve(missing);
    constexpr double kHalf = 6, kStep = 0.25, kBetween = 0.2;  // mm: the table, samples, and how much less is between
    for (double x = -kHalf; x <= kHalf; x += kStep) {
        for (double y = -kHalf; y <= kHalf; y += kStep) lowest_ = std::min(lowest_, height(x, y) - kBetween);
    }
}

double OcclusalSurface::height(double x, double y) const {
    double height = form(x, y);
    for (Eigen::Index i = 0; i < lifts_.size(); ++i) {
        height += lifts_[i] * influence(plan_.landmarks[static_cast<std::size_t>(i)], x, y);
    }
    return height;
}

double OcclusalSurface::form(double x, double y) const {
    constexpr double kBlend = 0.55;      // mm, over which slopes blend
    constexpr double kRidgeRound = 0.4;  // mm, of a ridge's crest
    double height = plan_.fossa;
    for (const Cusp& cusp : plan_.cusps) {
        height = -smoothUnion(-height, -cuspHeight(cusp, plan_.tip, x, y, height - kBlend), kBlend);
    }
    for (const OcclusalRidge& ridge : plan_.ridges) {
        const double away = nearestOnSegment(x, y, ridge.ax, ridge.ay, ridge.bx, ridge.by).square;
        const double ridgeHeight = ridge.z - ridge.slope * (std::sqrt(away + kRidgeRound * kRidgeRound) - kRidgeRound);
        height = -smoothUnion(-height, -ridgeHeight, kBlend);
    }
    return height;
}

double OcclusalSurface::grooveDepth(double x, double y) const {
    // Squared widths from the middle of a groove, where less than a thousandth of a micrometre is left.
    constexpr double kGone = 80;
    double deepest = 0;
    for (const OcclusalGroove& g : plan_.grooves) {
        const auto [part, square] = nearestOnSegment(x, y, g.ax, g.ay, g.bx, g.by);
        const double widths = square / (g.width * g.width);
        if (widths < kGone) deepest = std::max(deepest, std::lerp(g.depth, g.endDepth, part) * crevice(widths));
    }
    for (const OcclusalPit& pit : plan_.pits) {
        const double dx = x - pit.x, dy = y - pit.y, widths = (dx * dx + dy * dy) / (pit.width * pit.width);
        if (widths < kGone) deepest += pit.depth * std::exp(-widths);
    }
    return deepest;
}

}  // namespace tactooth
