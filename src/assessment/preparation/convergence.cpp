// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/convergence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "assessment/messages.h"
#include "geometry/util/degree.h"

namespace tactooth {
namespace {

constexpr std::size_t kSections = 8;       // after OAJDS 10.23880/oajds-16000309: eight fit better than four
constexpr double kLow = 0.2, kHigh = 0.8;  // of the height of the wall: the angles at both ends are round
constexpr double kLeastHeight = 0.3;       // mm between these, for a direction worth the name
constexpr std::size_t kLeastPairs = 6;     // sections with a wall on both sides

/// A piece of a section of the wall: its middle and its length.
struct Piece {
    double radius, height, length;  // mm
};

/// The pieces of the wall in the half-plane from the axis through `middle` along `outward`.
std::vector<Piece> sectionOf(const CutSurfaces& surfaces, const CutPatch& walls, const Vec3& axis,
                             const Vec3& outward) {
    const Vec3 across = axis.cross(outward);
    std::vector<Piece> pieces;
    for (const std::uint32_t i : walls) {
        std::array<Vec3, 3> from;
        std::array<double, 3> side{};
        for (int k = 0; k < 3; ++k) {
            const auto corner = static_cast<std::size_t>(k);
            from[corner] = surfaces.cut.mesh.corner(i, k) - surfaces.middle;
            side[corner] = across.dot(from[corner]);
        }
        std::array<Vec3, 2> ends;
        std::size_t count = 0;
        for (std::size_t k = 0; k < 3 && count < 2; ++k) {
            const std::size_t next = (k + 1) % 3;
            if ((side[k] < 0) == (side[next] < 0)) continue;
            ends[count++] = from[k] + side[k] / (side[k] - side[next]) * (from[next] - from[k]);
        }
        if (count < 2) continue;
        const Vec3 at = (ends[0] + ends[1]) / 2;
        if (outward.dot(at) <= 0) continue;
        pieces.push_back({outward.dot(at), axis.dot(at), (ends[1] - ends[0]).norm()});
    }
    return pieces;
}

/// Angle to the axis of the straight line through the pieces (least squares), rad; positive: nearer to the axis at its
/// outer end. Nothing where the wall is too low.
std::optional<double> taperOf(std::vector<Piece> pieces) {
    if (pieces.empty()) return std::nullopt;
    const auto [lowest, highest] = std::ranges::minmax_element(pieces, {}, &Piece::height);
    const double low = lowest->height, span = highest->height - low;
    if ((kHigh - kLow) * span < kLeastHeight) return std::nullopt;
    std::erase_if(
        pieces, [&](const Piece& each) { return each.height < low + kLow * span || each.height > low + kHigh * span; });
    double length = 0, radius = 0, height = 0;
    for (const Piece& each : pieces) {
        length += each.length;
        radius += each.length * each.radius;
        height += each.length * each.height;
    }
    if (!(length > 0)) return std::nullopt;
    double mixed = 0, square = 0;
    for (const Piece& each : pieces) {
        const double up = each.height - height / length;
        mixed += each.length * up * (each.radius - radius / length);
        square += each.length * up * up;
    }
    if (!(square > 0)) return std::nullopt;
    return std::atan(-mixed / square);
}

Measured bySections(const CutSurfaces& surfaces, const CutPatch& walls, const Vec3& axis) {
    const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
    std::vector<double> sums;
    for (std::size_t i = 0; i < kSections; ++i) {
        const double turn = std::numbers::pi * (static_cast<double>(i) + 0.5) / kSections;
        const Vec3 outward = std::cos(turn) * u + std::sin(turn) * v;
        const auto one = taperOf(sectionOf(surfaces, walls, axis, outward));
        const auto other = taperOf(sectionOf(surfaces, walls, axis, -outward));
        if (one && other) sums.push_back((*one + *other) / kDegree);
    }
    if (sums.size() < kLeastPairs) return Measured::none(msg::kWallTooLow);
    double mean = 0;
    for (const double each : sums) mean += each / static_cast<double>(sums.size());
    return Measured::of(mean);
}

Measured byCone(const CutSurfaces& surfaces, const CutPatch& inner, const Vec3& axis) {
    constexpr double kLeastArea = 2;  // mm^2
    if (areaOf(surfaces, inner) < kLeastArea) return Measured::none(msg::kWallTooLow);
    const LeastSpread normals = leastSpread(surfaces, inner, &Facet::normal);
    const double lean = normals.mean.dot(normals.direction);
    const double outward = normals.direction.dot(axis) < 0 ? -lean : lean;
    return Measured::of(2 * std::asin(std::clamp(outward, -1.0, 1.0)) / kDegree);
}

}  // namespace

Convergence convergence(const Preparation& preparation, const CutSurfaces& surfaces, const CutPatch& walls,
                        const CutPatch& inner) {
    const auto none = [](const MessageText& reason) {
        return Convergence{Measured::none(reason), Measured::none(reason), Measured::none(reason)};
    };
    if (surfaces.facets.empty()) return none(msg::kNothingCut);
    if (!surfaces.isCrown) return none(msg::kNoCrownPreparation);
    Convergence result{bySections(surfaces, walls, preparation.axis), byCone(surfaces, inner, preparation.axis), {}};
    if (!result.sections.value || !result.cone.value) {
        result.difference = Measured::none(msg::kWallTooLow);
    } else {
        result.difference = Measured::of(std::abs(*result.sections.value - *result.cone.value));
    }
    return result;
}

}  // namespace tactooth
