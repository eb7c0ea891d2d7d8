// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/cavity_extent.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "assessment/messages.h"
#include "collision/bvh/closest_point.h"
#include "geometry/util/parallel_for.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kStations = 0.05;      // mm between two widths
constexpr double kSlender = 1.5;        // length by width: a premolar's Class II cavity with a wide box has that
constexpr double kLeastLength = 0.5;    // mm longer than that
constexpr double kSideCosine = 0.7071;  // 45 degrees: an outside faces its direction
constexpr double kLift = 0.01;          // mm: start of a ray off the surface
constexpr double kCutOpen = 0.5;        // mm: where a ridge is cut through, the cut ends at the outside, which is round

/// Projected along the axis: along the cavity's longest direction, and across it.
struct Outline {
    Vec3 along, across;
    double low = 0, high = 0;  // along, mm

    Outline(const CutSurfaces& surfaces, const Vec3& axis) {
        const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
        Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
        for (const Facet& facet : surfaces.facets) {
            const Vec2 from(u.dot(facet.centre - surfaces.middle), v.dot(facet.centre - surfaces.middle));
            spread += facet.area * std::abs(facet.normal.dot(axis)) * from * from.transpose();
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
        const Vec2 longest = axes.eigenvectors().col(1);
        along = longest.x() * u + longest.y() * v;
        across = axis.cross(along);
        for (const Triangle& t : surfaces.cut.mesh.triangles) {
            for (const std::uint32_t vertex : t) {
                const double at = along.dot(surfaces.cut.mesh.vertices[vertex].cast<double>() - surfaces.middle);
                low = std::min(low, at);
                high = std::max(high, at);
            }
        }
    }
};

/// The extent of the cut across the outline at one place along it.
struct Width {
    double low = INFINITY, high = -INFINITY;
    Vec3 place = Vec3::Zero();  // at `high`

    [[nodiscard]] double value() const { return high - low; }
};

std::vector<Width> widthsOf(const CutSurfaces& surfaces, const Outline& outline) {
    std::vector<Width> widths(static_cast<std::size_t>((outline.high - outline.low) / kStations) + 1);
    const auto add = [&](const Vec3& a, const Vec3& b) {
        const double from = outline.along.dot(a - surfaces.middle) - outline.low;
        const double to = outline.along.dot(b - surfaces.middle) - outline.low;
        const auto first = static_cast<int>(std::ceil(std::min(from, to) / kStations - 0.5));
        const auto last = static_cast<int>(std::floor(std::max(from, to) / kStations - 0.5));
        for (int i = std::max(0, first); i <= last && i < static_cast<int>(widths.size()); ++i) {
            const double share = from == to ? 0 : ((i + 0.5) * kStations - from) / (to - from);
            const Vec3 place = a + share * (b - a);
            const double at = outline.across.dot(place - surfaces.middle);
            Width& width = widths[static_cast<std::size_t>(i)];
            width.low = std::min(width.low, at);
            if (at > width.high) width.place = place;
            width.high = std::max(width.high, at);
        }
    };
    const TriangleMesh& mesh = surfaces.cut.mesh;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k) add(mesh.corner(i, k), mesh.corner(i, (k + 1) % 3));
    }
    return widths;
}

Measured isthmusOf(const CutSurfaces& surfaces, const Vec3& axis) {
    const Outline outline(surfaces, axis);
    const std::vector<Width> widths = widthsOf(surfaces, outline);
    double widest = 0;
    for (const Width& width : widths) widest = std::max(widest, width.value());
    const double length = outline.high - outline.low;
    if (length < kSlender * widest + kLeastLength) return Measured::none(msg::kNoIsthmus);
    const auto end = static_cast<std::size_t>(widest / 2 / kStations);  // a round end is no longer than that
    const Width* narrowest = nullptr;
    for (std::size_t i = end; i + end < widths.size(); ++i) {
        if (widths[i].value() < 0) continue;  // nothing was cut there
        if (narrowest == nullptr || widths[i].value() < narrowest->value()) narrowest = &widths[i];
    }
    return narrowest == nullptr ? Measured::none(msg::kNoIsthmus) : Measured::at(narrowest->value(), narrowest->place);
}

/// The triangles of the uncut tooth that one sees from far away in `direction`, that face it, and that lie farther
/// along it than `least` (mm): the inner slopes of cusps do not.
TriangleMesh outsideToward(const SurfacePart& original, const Vec3& direction, double least, const Surface& whole) {
    const TriangleMesh& mesh = original.mesh();
    std::vector<std::uint8_t> isSeen(mesh.triangles.size());
    constexpr std::size_t kGrain = 256;  // rays
    parallelFor(
        mesh.triangles.size(),
        [&](std::size_t i) {
            const Vec3 normal = mesh.areaVector(i).stableNormalized();
            if (normal.dot(direction) < kSideCosine) return;
            const Vec3 middle = (mesh.corner(i, 0) + mesh.corner(i, 1) + mesh.corner(i, 2)) / 3;
            if (direction.dot(middle) < least) return;
            isSeen[i] = !firstHit(whole, {middle + kLift * normal, direction});
        },
        kGrain);
    TriangleMesh outside{mesh.vertices, {}};
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (isSeen[i] != 0) outside.triangles.push_back(mesh.triangles[i]);
    }
    return outside;
}

Measured ridgeToward(const Preparation& preparation, const CutSurfaces& surfaces, const Vec3& direction) {
    const Surface whole{.base = preparation.original};
    double end = -INFINITY;  // of the cut surface along the direction
    for (const Facet& facet : surfaces.facets) end = std::max(end, direction.dot(facet.centre));
    TriangleMesh mesh = outsideToward(*preparation.original, direction, end - kCutOpen, whole);
    if (mesh.empty()) return Measured::none(msg::kNoRidge);
    const SurfacePart outside(std::move(mesh));
    std::optional<double> least;
    Vec3 place = Vec3::Zero();
    for (const Triangle& t : surfaces.cut.mesh.triangles) {
        for (const std::uint32_t vertex : t) {
            const Vec3 at = surfaces.cut.mesh.vertices[vertex].cast<double>();
            const auto near = closestPoint(outside, at, least.value_or(INFINITY));
            if (!near || (least && near->distance >= *least)) continue;
            least = near->distance;
            place = at;
        }
    }
    // The cut surface ends kCavityDepth below the outside: there the ridge is cut through.
    constexpr double kCutThrough = 1.5 * kCavityDepth;
    return Measured::at(*least < kCutThrough ? 0 : *least, place);
}

}  // namespace

CavityExtent cavityExtent(const Preparation& preparation, const CutSurfaces& surfaces) {
    CavityExtent extent;
    const DentalDirections to(preparation.axis, preparation.mesialX);
    const auto all = [&](const MessageText& reason) {
        extent.isthmus = extent.mesialRidge = extent.distalRidge = Measured::none(reason);
        return extent;
    };
    const auto length = [box = boundingBox(surfaces.cut.mesh)](int axis) {
        return box.isEmpty() ? Measured::none(msg::kNothingCut) : Measured::of(box.sizes()[axis]);
    };
    extent.mesiodistal = length(0);
    extent.buccolingual = length(1);
    extent.vertical = length(2);
    if (surfaces.facets.empty()) return all(msg::kNothingCut);
    if (surfaces.isCrown) return all(msg::kNoCavity);
    if (!to.hasMesial || !to.hasBuccal) return all(msg::kNotOcclusal);
    extent.isthmus = isthmusOf(surfaces, preparation.axis);
    extent.mesialRidge = ridgeToward(preparation, surfaces, to.mesial);
    extent.distalRidge = ridgeToward(preparation, surfaces, -to.mesial);
    return extent;
}

}  // namespace tactooth
