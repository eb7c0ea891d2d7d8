// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/inner_angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "assessment/messages.h"
#include "assessment/preparation/cut_patch.h"
#include "assessment/preparation/quantile.h"
#include "collision/bvh/closest_point.h"
#include "geometry/util/parallel_for.h"
#include "session/control/surface_ray.h"

// A ball that rests on floor and wall touches each at one point, with the angle 2 b between the two normals. On the
// bisector, a sharp angle lies at radius / cos b from the middle of the ball, and one with the radius r at
// r + (radius - r) / cos b. What a ray finds there gives r.

namespace tactooth {
namespace {

const double kFloorCosine = std::cos(std::numbers::pi / 4);  // of normal and axis
constexpr int kPushes = 40;                                  // until a ball rests
constexpr double kRests = 1e-3;                              // mm: a ball so near touches
constexpr double kLeastTurn = 20 * std::numbers::pi / 180;   // rad between the two normals: less is one bent surface
constexpr double kMostTurn = 130 * std::numbers::pi / 180;   // more: the ball is stuck between two walls
constexpr double kSharpest = 0.05;                           // share of all angles
constexpr std::size_t kBallGrain = 16;                       // balls: some hundred closest points

std::shared_ptr<const SurfacePart> partOf(const CutSurfaces& surfaces, const CutPatch& patch) {
    if (patch.empty()) return nullptr;
    TriangleMesh mesh{surfaces.cut.mesh.vertices, {}};
    for (const std::uint32_t i : patch) mesh.triangles.push_back(surfaces.cut.mesh.triangles[i]);
    return std::make_shared<const SurfacePart>(std::move(mesh));
}

struct Angle {
    double radius;  // mm
    Vec3 place;
    double weight;  // mm^2
};

/// Rolls the ball from above one facet of the floor.
class Roller {
public:
    Roller(const SurfacePart& floor, const SurfacePart& wall, std::shared_ptr<const SurfacePart> whole)
        : sides_{&floor, &wall}, whole_{.base = std::move(whole)} {}

    [[nodiscard]] std::optional<Angle> angleFrom(const Facet& facet) const {
        Vec3 middle = facet.centre + kRollingBall * facet.normal;
        if (!closestPoint(*sides_[1], middle, kRollingBall - kRests)) return std::nullopt;  // no wall is near
        for (int i = 0; i < kPushes; ++i) {
            bool isFree = true;
            for (const SurfacePart* side : sides_) {
                const auto touched = closestPoint(*side, middle, kRollingBall - kRests / 4);
                if (!touched || !(touched->distance > 0)) continue;
                middle += (kRollingBall / touched->distance - 1) * (middle - touched->point);
                isFree = false;
            }
            if (isFree) break;
        }
        std::array<Vec3, 2> normals;
        for (std::size_t i = 0; i < 2; ++i) {
            const auto touched = closestPoint(*sides_[i], middle, kRollingBall + kRests);
            if (!touched || touched->distance < kRollingBall - kRests) return std::nullopt;
            normals[i] = (middle - touched->point) / touched->distance;
        }
        const double turn = std::acos(std::clamp(normals[0].dot(normals[1]), -1.0, 1.0));
        if (turn < kLeastTurn || turn > kMostTurn) return std::nullopt;
        const Vec3 inward = -(normals[0] + normals[1]).normalized();
        const auto hit = firstHit(whole_, {middle, inward});
        if (!hit) return std::nullopt;
        const double slant = 1 / std::cos(turn / 2);
        const double radius = (kRollingBall * slant - *hit) / (slant - 1);
        return Angle{std::clamp(radius, 0.0, kRollingBall), middle + *hit * inward, facet.area};
    }

private:
    std::array<const SurfacePart*, 2> sides_;
    Surface whole_;
};

}  // namespace

Measured innerAngleRadius(const Preparation& preparation, const CutSurfaces& surfaces) {
    if (surfaces.facets.empty()) return Measured::none(msg::kNothingCut);
    const CutPatch floorPatch = patchBetween(surfaces, preparation.axis, kFloorCosine, 1.1);
    const auto floor = partOf(surfaces, floorPatch);
    const auto wall = partOf(surfaces, patchBetween(surfaces, preparation.axis, -kFloorCosine, kFloorCosine));
    if (floor == nullptr || wall == nullptr) return Measured::none(msg::kNoInnerAngle);
    const Roller roller(*floor, *wall, preparation.prepared);
    std::vector<std::optional<Angle>> found(floorPatch.size());
    parallelFor(
        found.size(), [&](std::size_t i) { found[i] = roller.angleFrom(surfaces.facets[floorPatch[i]]); }, kBallGrain);
    std::vector<Angle> angles;
    double weight = 0;
    for (const std::optional<Angle>& each : found) {
        if (!each) continue;
        angles.push_back(*each);
        weight += each->weight;
    }
    if (angles.empty()) return Measured::of(kRollingBall);
    std::ranges::stable_sort(angles, {}, &Angle::radius);
    const Angle& sharp = quantileByArea(angles, weight, kSharpest, &Angle::weight);
    return Measured::at(sharp.radius, sharp.place);
}

}  // namespace tactooth
