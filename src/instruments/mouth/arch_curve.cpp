// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// K. H. Lu, "An orthogonal analysis of the form, symmetry and asymmetry of the dental arch", Arch. Oral Biol. 11
// (1966): an arch as a polynomial of fourth degree. Its two coefficients are chosen so that the line is 13 mm aside and
// 5.5 mm back at the lower canine, and 23 mm aside and 22 mm back at the lower first molar, the widths of an average
// mouth.
#include "instruments/mouth/arch_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tactooth {
namespace {

constexpr double kSquare = 0.0283, kFourth = 2.512e-5;  // 1/mm, 1/mm^3
constexpr double kEnd = 38;                             // mm aside: far behind the last molars

}  // namespace

double ArchCurve::depth(double x) const {
    const double square = x * x / (width_ * width_);
    return (kSquare + kFourth * square) * square;
}

double ArchCurve::halfWidth(double depth) const {
    if (depth <= 0) return 0;
    const double square = (std::sqrt(kSquare * kSquare + 4 * kFourth * depth) - kSquare) / (2 * kFourth);
    return width_ * std::sqrt(square);
}

double ArchCurve::slope(double x) const {
    const double part = x / width_;
    return (2 * kSquare + 4 * kFourth * part * part) * part / width_;
}

/// Gaussian quadrature with five points: exact to a micrometre, because the curvature is small.
double ArchCurve::length(double x) const {
    constexpr std::array<double, 5> kAt = {0.046910077030668, 0.230765344947158, 0.5, 0.769234655052842,
                                           0.953089922969332};
    constexpr std::array<double, 5> kWeight = {0.118463442528095, 0.239314335249683, 0.284444444444444,
                                               0.239314335249683, 0.118463442528095};
    double sum = 0;
    for (std::size_t i = 0; i < kAt.size(); ++i) sum += kWeight[i] * std::hypot(1.0, slope(kAt[i] * x));
    return sum * x;
}

ArchCurve::Place ArchCurve::at(double s) const {
    constexpr int kRounds = 12;  // of Newton's method, from below: each doubles the digits
    const double distance = std::abs(s);
    double x = 0.5 * distance;
    for (int i = 0; i < kRounds; ++i) x -= (length(x) - distance) / std::hypot(1.0, slope(x));
    const double side = s < 0 ? -1 : 1;
    const Vec3 along = Vec3(1, -side * slope(x), 0).normalized();
    return {Vec3(side * x, -depth(x), 0), along, Vec3(-along.y(), along.x(), 0)};
}

ArchCurve::Coordinates ArchCurve::of(double x, double y) const {
    const double aside = std::abs(x);
    double low = 0, high = kEnd;
    constexpr int kHalvings = 12;
    const auto ahead = [&](double t) { return t - aside + (depth(t) + y) * slope(t); };
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = (low + high) / 2;
        (ahead(middle) < 0 ? low : high) = middle;
    }
    // The last part in one secant step: the function is almost linear there.
    const double fromLow = ahead(low), fromHigh = ahead(high);
    const double t =
        fromHigh > fromLow ? std::clamp(low - fromLow / (fromHigh - fromLow) * (high - low), low, high) : low;
    const double dx = aside - t, dy = y + depth(t);
    const double out = dx * slope(t) + dy;
    const double s = length(t);
    return {x < 0 ? -s : s, std::copysign(std::hypot(dx, dy), out)};
}

double occlusalPlane(double depth) {
    constexpr double kLowest = 18, kRadius = 100;  // mm: at the second premolar; a sphere of four inches (Monson 1920)
    const double from = depth - kLowest;
    return (from * from - kLowest * kLowest) / (2 * kRadius);
}

}  // namespace tactooth
