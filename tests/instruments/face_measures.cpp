// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/face_measures.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "collision/bvh/closest_point.h"
#include "instruments/crown_measures.h"
#include "instruments/measured_faces.h"
#include "instruments/measured_teeth.h"
#include "instruments/permanent_teeth.h"
#include "instruments/relief_map.h"

namespace tactooth::test {
namespace {

template <typename Table>
const typename Table::value_type* rowOf(const Table& table, int fdi) {
    const auto* const found = std::ranges::find(table, fdi, &Table::value_type::fdi);
    return found == table.end() ? nullptr : found;
}

double topOf(const TriangleMesh& mesh) { return boundingBox(mesh).max().z(); }

/// Depth below `top` of the place that is farthest along an axis with a sign, in the middle half of the crown across it
/// and up to a height.
double contour(const TriangleMesh& mesh, int axis, double sign, double upTo) {
    const int across = 1 - axis;
    const ReliefMap side(mesh, across, 2, axis, sign);
    const double middle = side.box().center().x(), quarter = side.box().sizes().x() / 4;
    double farthest = -1e9, height = 0;
    for (double z = ReliefMap::kCell; z < upTo; z += ReliefMap::kCell) {
        for (double u = middle - quarter; u <= middle + quarter; u += ReliefMap::kCell) {
            const auto place = side.at(u, z);
            if (!place || sign * *place <= farthest) continue;
            farthest = sign * *place;
            height = z;
        }
    }
    return topOf(mesh) - height;
}

double outsideOf(const MeasuredContour& range, double depth) {
    return std::max({0.0, range.least - depth, depth - range.greatest});
}

using Line = std::vector<Vec2>;

/// mm that a line with increasing first coordinate runs above its lower convex hull, square to that.
double hollow(const Line& line) {
    const auto turn = [](const Vec2& a, const Vec2& b, const Vec2& c) {
        return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
    };
    Line hull;
    for (const Vec2& place : line) {
        while (hull.size() > 1 && turn(hull[hull.size() - 2], hull.back(), place) <= 0) hull.pop_back();
        hull.push_back(place);
    }
    double deepest = 0;
    std::size_t after = 1;
    for (const Vec2& place : line) {
        while (after + 1 < hull.size() && hull[after].x() < place.x()) ++after;
        const Vec2 &from = hull[after - 1], &to = hull[after];
        deepest = std::max(deepest, turn(from, to, place) / (to - from).norm());
    }
    return deepest;
}

/// The tongue's side of a crown at a height, from distal to mesial, without the round corners at its ends.
Line sectionOfFace(const ReliefMap& tongue, double z) {
    constexpr double kLeft = 0.93;  // share
    Line all;
    for (double x = tongue.box().min().x(); x < tongue.box().max().x(); x += ReliefMap::kCell) {
        if (const auto y = tongue.at(x, z)) all.emplace_back(x, *y);
    }
    const double middle = (all.front().x() + all.back().x()) / 2, half = kLeft * (all.back().x() - middle);
    std::erase_if(all, [&](const Vec2& place) { return std::abs(place.x() - middle) > half; });
    return all;
}

/// Thickness of the enamel in the middle of one side at a height.
class EnamelOfSide {
public:
    EnamelOfSide(const BuiltinTooth& tooth, double sign) : face_(tooth.outer, 0, 2, 1, sign), dentin_(tooth.dentin) {
        const double extent = sign > 0 ? boundingBox(tooth.outer).max().y() : -boundingBox(tooth.outer).min().y();
        constexpr double kCusps = 0.4;  // of the extent: from there on lie the cusps of the side
        const double from = isAnteriorTooth(tooth.fdi) ? -extent : kCusps * extent;
        for (const Vec3f& vertex : tooth.outer.vertices) {
            if (sign * vertex.y() > from) top_ = std::max(top_, static_cast<double>(vertex.z()));
        }
        constexpr double kThin = 0.05, kBelow = 1.5;  // mm: less is none
        neck_ = -kBelow;
        while (thicknessAt(neck_) < kThin) neck_ += ReliefMap::kCell;
    }

    [[nodiscard]] double atShare(double share) const { return thicknessAt(std::lerp(neck_, top_, share)); }

private:
    [[nodiscard]] double thicknessAt(double z) const {
        return closestPoint(dentin_, Vec3(0, face_.at(0, z).value_or(1e9), z))->distance;
    }

    ReliefMap face_;
    SurfacePart dentin_;
    double top_ = 0, neck_ = 0;
};

}  // namespace

Contours contoursOf(const BuiltinTooth& tooth) {
    const TriangleMesh mesh = mesialFrame(tooth);
    const double top = topOf(mesh), facial = isAnteriorTooth(tooth.fdi) ? top / 3 : top;
    return {contour(mesh, 0, 1, top), contour(mesh, 0, -1, top), contour(mesh, 1, 1, facial),
            contour(mesh, 1, -1, facial)};
}

std::optional<double> contourDeviation(const BuiltinTooth& tooth) {
    const auto* const measured = rowOf(kMeasuredContours, tooth.fdi);
    if (measured == nullptr) return std::nullopt;
    const Contours is = contoursOf(tooth);
    return std::max({outsideOf(measured->mesial, is.mesial), outsideOf(measured->distal, is.distal),
                     outsideOf(measured->buccal, is.buccal), outsideOf(measured->lingual, is.lingual)});
}

std::optional<double> fossaDeviation(const BuiltinTooth& tooth) {
    const auto* const measured = rowOf(kMeasuredFossae, tooth.fdi);
    if (measured == nullptr) return std::nullopt;
    const TriangleMesh mesh = mesialFrame(tooth);
    const ReliefMap tongue(mesh, 0, 2, 1, -1);
    const double top = topOf(mesh), length = rowOf(kAverageTeeth, tooth.fdi)->crown;
    const double stretch =
        rowOf(kAverageTeeth, tooth.fdi)->faciolingual / rowOf(kMeasuredCrowns, tooth.fdi)->buccolingual;
    Line profile;
    constexpr double kEdge = 0.25, kNeck = 0.95;  // mm; share of the crown
    for (double depth = kEdge; depth < kNeck * length; depth += ReliefMap::kCell) {
        profile.emplace_back(depth, tongue.at(0, top - depth).value_or(0));
    }
    double largest = std::abs(hollow(profile) - stretch * measured->profile);
    for (std::size_t i = 0; i < kFossaDepths.size(); ++i) {
        const double is = hollow(sectionOfFace(tongue, top - kFossaDepths[i] * length));
        largest = std::max(largest, std::abs(is - stretch * measured->depth[i]));
    }
    return largest;
}

std::optional<double> enamelDeviation(const BuiltinTooth& tooth) {
    const auto* const measured = rowOf(kMeasuredEnamel, tooth.fdi);
    if (measured == nullptr) return std::nullopt;
    const EnamelOfSide buccal(tooth, 1), lingual(tooth, -1);
    double largest = 0;
    for (std::size_t i = 0; i < kEnamelHeights.size(); ++i) {
        largest = std::max({largest, std::abs(buccal.atShare(kEnamelHeights[i]) - measured->buccal[i]),
                            std::abs(lingual.atShare(kEnamelHeights[i]) - measured->lingual[i])});
    }
    return largest;
}

}  // namespace tactooth::test
