// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/bur_outline.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

using std::numbers::pi;

/// A part of the outline; `at` gives its points from 0 (the end of the part before) to 1.
struct Piece {
    std::function<OutlinePoint(double)> at;
    double weight = 0;  ///< mm of length, more where it is curved
    int fewest = 1;     ///< smallest number of corners
};

constexpr double kBendWeight = 2.5;  // a curve needs more corners than a straight part of the same length

Piece point(double radius, double z) {
    return {[=](double) { return OutlinePoint{radius, z}; }, 0, 1};
}

Piece line(OutlinePoint from, OutlinePoint to) {
    const double length = std::hypot(to.radius - from.radius, to.z - from.z);
    return {[=](double t) {
                return OutlinePoint{std::lerp(from.radius, to.radius, t), std::lerp(from.z, to.z, t)};
            },
            length, 1};
}

/// An arc of an ellipse whose centre is on the axis at height `centre`, or `aside` of it; angles from the lower pole.
Piece arc(double centre, double halfHeight, double radius, double from, double to, double aside = 0) {
    const double length = (to - from) * (halfHeight + radius) / 2;
    return {[=](double t) {
                const double angle = std::lerp(from, to, t);
                return OutlinePoint{aside + radius * std::sin(angle), centre - halfHeight * std::cos(angle)};
            },
            kBendWeight * length, 2};
}

/// One half of a pointed arch: from the axis at the bottom to `radius` at `height`, where it is vertical.
Piece ogive(double radius, double height) {
    const double curvature = (radius * radius + height * height) / (2 * radius);
    return {[=](double t) {
                const double z = height * t, left = height - z;
                return OutlinePoint{std::sqrt(curvature * curvature - left * left) - (curvature - radius), z};
            },
            kBendWeight * std::hypot(radius, height), 3};
}

double slopeOf(const BurSpec& spec) { return std::tan(spec.taperDegrees * pi / 360); }

std::vector<Piece> roundPieces(const BurSpec& spec) {
    const double r = spec.headDiameter / 2;
    const double end = std::acos(std::clamp(1 - spec.headLength / r, -1.0, 1.0));
    return {arc(r, r, r, 0, pi / 2), arc(r, r, r, pi / 2, end)};
}

std::vector<Piece> flatEndPieces(const BurSpec& spec) {
    const double r = spec.headDiameter / 2, narrowing = std::abs(slopeOf(spec)) * spec.headLength;
    const double tip = spec.taperDegrees > 0 ? r - narrowing : r;
    const double end = spec.taperDegrees < 0 ? r - narrowing : r;
    return {point(tip, 0), line({tip, 0}, {end, spec.headLength})};
}

/// A dome of this height over the tip, then a straight side.
std::vector<Piece> domePieces(double tip, double dome, OutlinePoint end) {
    return {arc(dome, dome, tip, 0, pi / 2), line({tip, dome}, end)};
}

std::vector<Piece> pearPieces(const BurSpec& spec) {
    constexpr double kFlatness = 0.8;  // a pear's end is flatter than a ball
    const double r = spec.headDiameter / 2;
    return domePieces(r, kFlatness * r, {r + slopeOf(spec) * spec.headLength, spec.headLength});
}

std::vector<Piece> roundEndTaperPieces(const BurSpec& spec) {
    const double r = spec.headDiameter / 2, slope = slopeOf(spec);
    const double tip = (r - slope * spec.headLength) / (1 - slope);
    return domePieces(tip, tip, {r, spec.headLength});
}

std::vector<Piece> flamePieces(const BurSpec& spec) {
    constexpr double kWidest = 0.55, kEndRadius = 0.72;  // share of the head's length; share of its radius
    const double r = spec.headDiameter / 2, z = kWidest * spec.headLength;
    const double end = std::acos(kEndRadius), above = (spec.headLength - z) / std::sin(end);
    return {ogive(r, z), arc(z, above, r, pi / 2, pi / 2 + end)};
}

std::vector<Piece> footballPieces(const BurSpec& spec) {
    constexpr double kEndRadius = 0.55;  // share of the head's radius
    const double r = spec.headDiameter / 2, end = std::acos(kEndRadius);
    const double half = spec.headLength / (1 + std::sin(end));
    return {arc(half, half, r, 0, pi / 2), arc(half, half, r, pi / 2, pi / 2 + end)};
}

std::vector<Piece> torpedoPieces(const BurSpec& spec) {
    constexpr double kPoint = 2.4;  // length of the point, in radii
    const double r = spec.headDiameter / 2, slope = slopeOf(spec);
    const double tip = (r - slope * spec.headLength) / (1 - kPoint * slope), height = kPoint * tip;
    return {ogive(tip, height), line({tip, height}, {r, spec.headLength})};
}

std::vector<Piece> needlePieces(const BurSpec& spec) {
    constexpr double kPoint = 0.12;  // radius of the point as a share of the head's
    const double r = spec.headDiameter / 2;
    return domePieces(kPoint * r, kPoint * r, {r, spec.headLength});
}

std::vector<Piece> wheelPieces(const BurSpec& spec) {
    constexpr double kEdge = 0.35;  // mm of rounding
    const double r = spec.headDiameter / 2, inner = r - kEdge, top = spec.headLength - kEdge;
    return {point(inner, 0), arc(kEdge, kEdge, kEdge, 0, pi / 2, inner), line({r, kEdge}, {r, top}),
            arc(top, kEdge, kEdge, pi / 2, pi, inner)};
}

std::vector<Piece> connectedComponents(const BurSpec& spec) {
    const double r = spec.headDiameter / 2;
    switch (spec.kind) {
        case BurKind::Round:
            return roundPieces(spec);
        case BurKind::InvertedCone:
        case BurKind::StraightFissure:
        case BurKind::TaperedFissure:
            return flatEndPieces(spec);
        case BurKind::DomeFissure:
            return domePieces(r, r, {r, spec.headLength});
        case BurKind::RoundEndTaper:
            return roundEndTaperPieces(spec);
        case BurKind::Pear:
            return pearPieces(spec);
        case BurKind::Flame:
            return flamePieces(spec);
        case BurKind::Football:
            return footballPieces(spec);
        case BurKind::Torpedo:
            return torpedoPieces(spec);
        case BurKind::Needle:
            return needlePieces(spec);
        case BurKind::Wheel:
            break;
    }
    return wheelPieces(spec);
}

}  // namespace

std::vector<OutlinePoint> burOutline(const BurSpec& spec, int count) {
    TACTOOTH_ASSERT(spec.headDiameter > 0 && spec.headLength > 0 && count > 0);
    const std::vector<Piece> pieces = connectedComponents(spec);
    double weight = 0;
    int needed = 0;
    for (const Piece& piece : pieces) {
        weight += piece.weight;
        needed += piece.fewest;
    }
    const int spare = std::max(0, count - needed);
    std::vector<OutlinePoint> outline;
    double shared = 0;
    int given = 0;
    for (const Piece& piece : pieces) {
        shared += piece.weight;
        const int until = static_cast<int>(std::lround(spare * shared / weight));
        const int corners = piece.fewest + until - given;
        given = until;
        for (int i = 1; i <= corners; ++i) outline.push_back(piece.at(static_cast<double>(i) / corners));
    }
    return outline;
}

double endRadius(const BurSpec& spec) {
    constexpr int kFine = 400;
    double least = spec.headDiameter / 2;
    for (const auto& [radius, z] : burOutline(spec, kFine)) {
        if (radius <= 0) continue;
        // The ball through this point that touches the tip.
        least = std::min(least, z > 0 ? (radius * radius + z * z) / (2 * z) : 0);
    }
    return least;
}

}  // namespace tactooth
